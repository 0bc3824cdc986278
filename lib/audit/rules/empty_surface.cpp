#include <fmt/format.h>

#include <algorithm>

#include "audit/rules/rules.hpp"

namespace gapcheck::audit {
namespace {

void add(const RuleInfo& rule, Context& context, Report& report, std::uint32_t contact, char side,
         const std::string& reason) {
  const model::Contact& c = context.model().contacts[contact];
  Finding f = finding(rule, fmt::format("surface {} of *{} is empty: {}", side, c.written, reason),
                      context.path(c.place.file), c.place.line);
  f.contact = c.id.value;
  report.findings.push_back(std::move(f));
}

/// A contact that is not searched has no surfaces built: its sides are looked up alone.
void check_unsearched(const RuleInfo& rule, Context& context, Report& report, std::uint32_t index) {
  const model::Model& model = context.model();
  const model::Contact& c = model.contacts[index];
  const contact::ContactType type = contact::classify(c);
  if (type.treatment == contact::Treatment::none && type.code != "25") return;
  const auto one = [&](const model::SurfaceInput& input, char side) {
    const auto selection = contact::select(model, input, type, model.mesh.nodes.x);
    if (!selection.empty_reason.empty() && !selection.unknown_id && !selection.unsupported) add(rule, context, report, index, side, selection.empty_reason);
  };
  one(c.a, 'A');
  const bool has_b = type.treatment == contact::Treatment::one_way || type.treatment == contact::Treatment::two_way;
  if (has_b) one(c.b, 'B');
}

bool chosen(const Context& context, const model::Contact& c) {
  const auto& ids = context.options().contacts;
  return c.known && !c.own_layout && (ids.empty() || std::find(ids.begin(), ids.end(), c.id.value) != ids.end());
}

void run(const RuleInfo& rule, Context& context, Report& report) {
  const std::vector<model::Contact>& contacts = context.model().contacts;
  const bool searched = context.search_wanted();
  if (searched)
    for (const contact::EmptySurface& empty : context.initial().empty)
      add(rule, context, report, empty.contact, empty.side, empty.reason);
  for (std::uint32_t i = 0; i < contacts.size(); ++i)
    if (chosen(context, contacts[i]) && !(searched && contact::classify(contacts[i]).checked()))
      check_unsearched(rule, context, report, i);
}

}  // namespace

const Rule empty_surface{
    {"GC503", "empty-surface", Severity::error, "a side of a contact names nothing that could be in contact"}, run};

}  // namespace gapcheck::audit
