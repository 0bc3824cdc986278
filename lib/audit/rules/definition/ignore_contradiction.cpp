#include <fmt/format.h>

#include "audit/grouped.hpp"
#include "audit/rules.hpp"

namespace gapcheck::audit::rule::ignore_contradiction {
namespace {

/// Where IGNORE may stand, in the order in which the solver looks.
struct Source {
  std::string_view name;
  std::int64_t value;
};

void run(const RuleInfo& rule, Context& context, Report& report) {
  std::vector<Finding> found;
  for (const std::uint32_t i : context.read_contacts()) {
    const model::Contact& contact = context.model().contacts[i];
    const contact::ContactType type = contact::classify(contact);
    if (!contact::knows_ignore(type)) continue;
    const Source sources[] = {{"the MPP card", contact.mpp_ignore.value_or(0)},
                              {"card C", contact.ignore.value_or(0)},
                              {"*CONTROL_CONTACT", context.model().controls.ignore}};
    const Source* wins = nullptr;
    const Source* loses = nullptr;
    for (const Source& source : sources) {
      if (source.value == 0) continue;
      if (wins == nullptr)
        wins = &source;
      else if (loses == nullptr && source.value != wins->value)
        loses = &source;
    }
    if (loses == nullptr) continue;
    found.push_back(finding_at(
        rule, context, contact,
        fmt::format(
            "IGNORE = {} on {} and {} on {}: {} counts, and the other is ignored; write the value that is meant "
            "in one place",
            wins->value, wins->name, loses->value, loses->name, wins->value)));
    // A contact may well differ from what holds for all others.
    if (loses == &sources[2]) found.back().severity = Severity::note;
  }
  add_first(report, std::move(found), "more contacts have contradictory values of IGNORE");
}

}  // namespace

const Rule definition{
    {"GC409", "ignore-contradiction", Severity::warning, "IGNORE is given twice, with different values"}, run};

}  // namespace gapcheck::audit::rule::ignore_contradiction
