#include <fmt/format.h>

#include <algorithm>

#include "audit/grouped.hpp"
#include "audit/rules.hpp"
#include "contact/definition/friction.hpp"

namespace gapcheck::audit::rule::friction_table {
namespace {

struct Problem {
  std::string text;  ///< empty: none
  Severity severity = Severity::error;
};

Problem problem(const model::Model& model, const model::Contact& contact) {
  const std::size_t tables = model.friction_tables.size();
  if (!contact::takes_friction_table(contact))
    return {fmt::format("FS = -2 is not available for *{}; give FS and FD on the contact", contact.written),
            Severity::warning};
  if (tables == 0)
    return {
        "FS = -2 takes the friction from *DEFINE_FRICTION, and the deck has none; define the table, or give FS and "
        "FD on the contact"};
  const auto named = static_cast<std::int64_t>(std::clamp(contact.fd, -1e15, 1e15));
  const bool there = static_cast<double>(named) == contact.fd && model.friction_tables.contains(named);
  if (contact.fd != 0 && !there)
    return {
        fmt::format("FD = {:g} names no table of friction (FS = -2); the deck has {} *DEFINE_FRICTION, the first of "
                    "them {}",
                    contact.fd, tables, model.friction_tables.begin()->first)};
  if (contact.fd == 0 && tables > 1)
    return {fmt::format("FS = -2 and FD = 0, but the deck has {} *DEFINE_FRICTION; name one of them in FD", tables),
            Severity::warning};
  return {};
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  std::vector<Finding> found;
  for (const ContactIndex i : context.read_contacts()) {
    const model::Contact& contact = context.model().contact(i);
    if (contact.fs != contact::friction_by_table || !contact::has_friction(contact)) continue;
    Problem p = problem(context.model(), contact);
    if (p.text.empty()) continue;
    found.push_back(finding_at(rule, context, contact, std::move(p.text)));
    found.back().severity = p.severity;
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Finding& a, const Finding& b) { return a.severity > b.severity; });
  add_first(report, std::move(found), "more contacts with FS = -2 have no table of friction");
}

}  // namespace

const Rule definition{
    {"GC408", "friction-table", Severity::error, "a contact takes its friction from a table that is not there",
     Need::model, "The contact runs without friction, or the solver stops"},
    run};

}  // namespace gapcheck::audit::rule::friction_table
