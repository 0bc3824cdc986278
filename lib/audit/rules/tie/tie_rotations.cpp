#include <fmt/format.h>

#include <algorithm>

#include "audit/rules.hpp"
#include "audit/shared/tied_contacts.hpp"

namespace gapcheck::audit::rule::tie_rotations {
namespace {

using contact::JudgedNode;

/// Shells and beams have rotations that the tie leaves free. Null shells only cover what is below them.
bool has_rotations(const model::Model& model, PartIndex index) {
  if (index == none<PartIndex>) return false;
  const model::Part& part = model.part(index);
  if (part.material && model.materials[*part.material].null_material) return false;
  if (part.composite_thickness > 0) return true;
  if (!part.section) return false;
  const model::SectionKind kind = model.sections[*part.section].kind;
  return kind == model::SectionKind::shell || kind == model::SectionKind::beam;
}

/// Nodes of shells and beams whose nodes are all tied: the element itself keeps their rotations.
std::vector<bool> held_by_elements(const model::Model& model, std::span<const JudgedNode> nodes) {
  std::vector<bool> tied(model.mesh.nodes.size()), held(tied.size());
  for (const JudgedNode& node : nodes)
    if (node.tied()) tied[node.node.value] = true;
  const auto hold = [&](const auto& elements, std::size_t corners) {
    for (const auto& element : elements.nodes) {
      const auto end = element.begin() + static_cast<std::ptrdiff_t>(corners);
      if (!std::all_of(element.begin(), end, [&](NodeIndex n) { return n != none<NodeIndex> && tied[n.value]; }))
        continue;
      for (auto n = element.begin(); n != end; ++n) held[n->value] = true;
    }
  };
  hold(model.mesh.shells, 4);
  hold(model.mesh.beams, 2);
  return held;
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const model::Model& model = context.model();
  std::vector<bool> rotating(model.parts.size());
  for (std::uint32_t p = 0; p < rotating.size(); ++p) rotating[p] = has_rotations(model, PartIndex{p});
  for_each_tied_contact(context, [&](ContactIndex c, std::span<const JudgedNode> nodes) {
    const contact::ContactType type = contact::classify(model.contact(c));
    if (!contact::leaves_rotations_free(type)) return;
    const std::vector<bool> held = held_by_elements(model, nodes);
    std::uint64_t tied = 0, free = 0;
    std::int64_t first = 0;
    for (const JudgedNode& node : nodes) {
      if (!node.tied()) continue;
      ++tied;
      if (node.part == none<PartIndex> || !rotating[node.part.value] || held[node.node.value]) continue;
      const std::int64_t id = model.mesh.nodes.id[node.node.value];
      if (free++ == 0 || id < first) first = id;
    }
    if (free == 0) return;
    Finding f =
        finding_at(rule, context, model.contact(c),
                   fmt::format("type {} ties {} of shells or beams by their translations alone (of {} tied): they "
                               "turn freely and the joint is too soft; use {}{}",
                               type.printed(), node_count(free), tied,
                               model::recommended_keyword(model::ContactCode::tied_shell_edge),
                               model::suffix(type.offset == contact::TieOffset::penalty ? contact::TieOffset::beam
                                                                                        : contact::TieOffset::none)));
    f.node = first;
    f.count = free;
    report.findings.push_back(std::move(f));
  });
}

}  // namespace

const Rule definition{{"GC205", "tie-rotations", Severity::warning, "shells or beams are tied without their rotations",
                       Need::ties, "The joint turns like a hinge"},
                      run};

}  // namespace gapcheck::audit::rule::tie_rotations
