#include <fmt/format.h>

#include "audit/grouped.hpp"
#include "audit/rules.hpp"
#include "contact/definition/contact_type.hpp"

namespace gapcheck::audit::rule::tied_friction {
namespace {

/// Ties without failure: the values of TIEBREAK types count once the tie is broken, and FS and FD of TIED_..._FAILURE
/// are the stresses at failure.
bool ignores_friction(const model::Contact& contact) {
  return contact::classify(contact).family == contact::Family::tied && contact.kind->tie == model::TieForm::permanent;
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  std::vector<Finding> found;
  for (const ContactIndex i : context.read_contacts()) {
    const model::Contact& contact = context.model().contact(i);
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
    {"GC406", "tied-friction", Severity::warning, "a tied contact has friction values, which it ignores", Need::model,
     "The friction has no effect"},
    run};

}  // namespace gapcheck::audit::rule::tied_friction
