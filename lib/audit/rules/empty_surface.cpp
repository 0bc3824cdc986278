#include <fmt/format.h>

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

/// A contact whose penetrations are not decided had no surfaces built.
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

void run(const RuleInfo& rule, Context& context, Report& report) {
  const contact::InitialState& initial = context.initial();
  for (const contact::EmptySurface& empty : initial.empty) add(rule, context, report, empty.contact, empty.side, empty.reason);
  for (std::uint32_t i = 0; i < initial.contacts.size(); ++i) {
    const model::Contact& c = context.model().contacts[i];
    const bool selected = initial.contacts[i].not_checked != "not selected";
    if (selected && c.known && !c.own_layout && !contact::classify(c).checked())
      check_unsearched(rule, context, report, i);
  }
}

}  // namespace

const Rule empty_surface{
    {"GC503", "empty-surface", Severity::error, "a side of a contact names nothing that could be in contact"}, run};

}  // namespace gapcheck::audit
