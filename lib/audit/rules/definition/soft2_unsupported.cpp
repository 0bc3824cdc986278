#include <fmt/format.h>

#include "audit/grouped.hpp"
#include "audit/rules.hpp"
#include "contact/definition/contact_type.hpp"

namespace gapcheck::audit::rule::soft2_unsupported {
namespace {

/// What is wrong with SOFT; empty: nothing.
std::string problem(const model::Contact& contact) {
  const std::int64_t soft = contact.soft;
  if (soft != 0 && soft != 1 && soft != 2 && soft != 4 && soft != 6)
    return fmt::format(
        "SOFT = {} is none of 0, 1, 2, 4 and 6; correct card A of *{}, or look for a line too many or too "
        "few before it",
        soft, contact.written);
  const contact::ContactType type = contact::classify(contact);
  const bool penalty = type.treatment != contact::Treatment::none && type.family != contact::Family::tied &&
                       type.family != contact::Family::mortar && type.family != contact::Family::other;
  if (!penalty) return {};
  if (soft == 2 && !contact::has_soft_2(type))
    return fmt::format(
        "*{} has no SOFT = 2: the solver takes SOFT = 1; write 1, or take a SURFACE_TO_SURFACE or "
        "SINGLE_SURFACE type",
        contact.written);
  if (soft > 2 && type.family != contact::Family::forming)
    return fmt::format("SOFT = {} is for forming contacts only, and *{} is none; take 0, 1 or 2", soft,
                       contact.written);
  return {};
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  std::vector<Finding> found;
  for (const ContactIndex i : context.read_contacts()) {
    const model::Contact& contact = context.model().contact(i);
    const std::string text = problem(contact);
    if (!text.empty()) found.push_back(finding_at(rule, context, contact, text));
  }
  add_first(report, std::move(found), "more contacts have a SOFT that their type does not have");
}

}  // namespace

const Rule definition{
    {"GC412", "soft2-unsupported", Severity::warning, "a contact asks for a SOFT that its type does not have",
     Need::model, "The solver uses another formulation than the deck asks for"},
    run};

}  // namespace gapcheck::audit::rule::soft2_unsupported
