#include <fmt/format.h>

#include "audit/grouped.hpp"
#include "audit/rules.hpp"
#include "contact/definition/contact_type.hpp"

namespace gapcheck::audit::rule::ignore_contradiction {
namespace {

/// Where IGNORE may be set, in the solver's order of precedence.
struct Source {
  std::string_view name;
  std::int64_t value;
};

void run(const RuleIdentity& rule, Context& context, Report& report) {
  std::vector<Finding> found;
  for (const ContactIndex i : context.read_contacts()) {
    const model::Contact& contact = context.model().contact(i);
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
    // A contact may intentionally differ from the general setting.
    if (loses == &sources[2]) found.back().severity = Severity::note;
  }
  add_first(report, std::move(found), "more contacts have contradictory values of IGNORE");
}

}  // namespace

const Rule definition{
    {"GC409", "ignore-contradiction", Severity::warning, "IGNORE is given twice, with different values", Need::model,
     "One of the two values has no effect"},
    run};

}  // namespace gapcheck::audit::rule::ignore_contradiction
