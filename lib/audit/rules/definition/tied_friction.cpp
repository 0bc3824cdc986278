#include <fmt/format.h>

#include "audit/grouped.hpp"
#include "audit/rules.hpp"

namespace gapcheck::audit::rule::tied_friction {
namespace {

/// Ties without failure: what TIEBREAK types have on the card counts once the tie is broken, and FS and FD of
/// TIED_..._FAILURE are the stresses at failure.
bool ignores_friction(const model::Contact& contact) {
  return contact::classify(contact).family == contact::Family::tied &&
         contact.keyword.find("TIEBREAK") == std::string::npos && contact.keyword.find("_FAILURE") == std::string::npos;
}

void run(const RuleInfo& rule, Context& context, Report& report) {
  std::vector<Finding> found;
  for (const std::uint32_t i : context.read_contacts()) {
    const model::Contact& contact = context.model().contacts[i];
    if ((contact.fs == 0 && contact.fd == 0) || !ignores_friction(contact)) continue;
    found.push_back(finding_at(rule, context, contact,
                               fmt::format("*{} ties and never slides: FS = {:g} and FD = {:g} are ignored; remove "
                                           "them, or take a type with friction",
                                           contact.written, contact.fs, contact.fd)));
  }
  add_first(report, std::move(found), "more tied contacts have friction values");
}

}  // namespace

const Rule definition{
    {"GC406", "tied-friction", Severity::warning, "a tied contact has friction values, which it ignores"}, run};

}  // namespace gapcheck::audit::rule::tied_friction
