#include <fmt/format.h>

#include "audit/members.hpp"
#include "audit/rules.hpp"
#include "audit/shared/mesh_finding.hpp"
#include "audit/shared_results.hpp"

namespace gapcheck::audit::rule::moved_into_another {
namespace {

std::string element_name(std::int64_t element, std::int64_t part) {
  std::string name = element == 0 ? "a segment" : fmt::format("element {}", element);
  return part == 0 ? name : name + fmt::format(" (part {})", part);
}

Finding describe(const RuleIdentity& rule, const Context& context, const contact::MovedInto& node) {
  const Penetration& into = node.into;
  const model::Contact& contact = context.model().contact(ContactIndex{into.contact});
  Finding finding = finding_at(
      rule, context, contact,
      fmt::format(
          "node {} (part {}), moved by {:.6g} out of {}, lands {:.6g} inside the contact distance {:.6g} of {}: "
          "the run starts with that force and its energy, from nothing; correct the geometry",
          into.node, into.part, node.moved, element_name(node.element, node.element_part), into.depth,
          into.contact_distance, element_name(into.element, into.element_part)));
  finding.node = into.node;
  finding.part = into.part;
  finding.element = into.element;
  finding.element_part = into.element_part;
  finding.penetration = into.depth;
  finding.point = into.original;
  if (into.line != 0) {
    finding.file = context.path(FileIndex{into.file});
    finding.line = into.line;
  }
  return finding;
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const std::vector<contact::MovedInto>& nodes = context.results().initial().moved_into;
  const model::Model& model = context.model();
  std::vector<Found> found;
  for (std::size_t i = 0; i < nodes.size(); ++i) found.push_back({nodes[i].into.contact, nodes[i].into.depth, i});
  add_grouped(
      report, std::move(found), [&](const Found& f) { return describe(rule, context, nodes[f.item]); },
      [&](const Found& f, std::uint64_t count) {
        const model::Contact& contact = model.contact(ContactIndex{static_cast<std::uint32_t>(f.group)});
        Finding finding = finding_at(rule, context, contact,
                                     fmt::format("{} more nodes of contact {} are moved out of one element and into "
                                                 "another, up to {:.6g} deep",
                                                 count, contact.id.value, f.weight));
        finding.penetration = f.weight;
        return finding;
      },
      collect_nodes(context, [&](const Found& f) { return nodes[f.item].node; }));
}

}  // namespace

const Rule definition{
    {"GC112", "moved-into-another", Severity::error, "a node that the solver moves out of one element lands in another",
     Need::moved_nodes, "The solver moves nodes out of one element into another: energy from nothing"},
    run};

}  // namespace gapcheck::audit::rule::moved_into_another
