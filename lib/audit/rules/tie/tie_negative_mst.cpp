#include <fmt/format.h>

#include "audit/grouped.hpp"
#include "audit/rules.hpp"
#include "contact/definition/contact_type.hpp"

namespace gapcheck::audit::rule::tie_negative_mst {
namespace {

/// Empty: the reach comes from SST, or from no card at all.
std::string problem(const model::Contact& contact, const contact::ContactType& type) {
  if (!(contact.mst < 0)) return {};
  if (contact.sst >= 0)
    return fmt::format(
        "MST = {:g} is negative and SST = {:g} is not: MST gives the reach of the tie, which may make the joint "
        "oscillate; give the reach with a negative SST, and leave MST at 0",
        contact.mst, contact.sst);
  // The oscillations are known of forms that carry moments.
  if (type.offset == contact::TieOffset::beam && contact.mst < contact.sst)
    return fmt::format(
        "MST = {:g} gives most of the reach and SST = {:g} little, which may make the joint oscillate; give the reach "
        "with SST alone",
        contact.mst, contact.sst);
  return {};
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  std::vector<Finding> found;
  for (const ContactIndex i : context.read_contacts()) {
    const model::Contact& contact = context.model().contact(i);
    const contact::ContactType type = contact::classify(contact);
    if (type.family != contact::Family::tied) continue;
    const std::string text = problem(contact, type);
    if (!text.empty()) found.push_back(finding_at(rule, context, contact, text));
  }
  add_first(report, std::move(found), "more ties give their reach with MST");
}

}  // namespace

const Rule definition{
    {"GC210", "tie-negative-mst", Severity::warning, "a tie gives its reach with a negative MST in place of SST",
     Need::model, "The reach may not be the intended one"},
    run};

}  // namespace gapcheck::audit::rule::tie_negative_mst
