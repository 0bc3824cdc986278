#include <fmt/format.h>

#include <algorithm>

#include "audit/rules.hpp"
#include "audit/shared/tied_contacts.hpp"

namespace gapcheck::audit::rule::tie_by_part {
namespace {

using contact::JudgedNode;

/// How the tracked side names parts; empty: it does not.
std::string named_parts(const model::SurfaceInput& input) {
  using enum model::SurfaceType;
  switch (static_cast<model::SurfaceType>(input.type)) {
    case part_set:
      return fmt::format("part set {}", input.id);
    case part:
      return fmt::format("part {}", input.id);
    case branch:
      return fmt::format("branch {}", input.id);
    case all:
      return "all parts";
    case exempted_part_set:
      return fmt::format("all parts but those of part set {}", input.id);
    default:
      return {};
  }
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const model::Model& model = context.model();
  for_each_tied_contact(context, [&](ContactIndex c, std::span<const JudgedNode> nodes) {
    const model::Contact& contact = model.contact(c);
    const std::string side = named_parts(contact.a);
    if (side.empty()) return;
    const auto untied = static_cast<std::uint64_t>(
        std::count_if(nodes.begin(), nodes.end(), [](const JudgedNode& node) { return !node.tied(); }));
    if (untied == 0) return;
    Finding f = finding_at(
        rule, context, contact,
        fmt::format("the tracked side is {}: of {} near the reference surface {} untied, and nobody "
                    "can tell which were meant to tie; name the nodes of the joint in a node set",
                    side, node_count(nodes.size()), untied == 1 ? "1 stays" : fmt::format("{} stay", untied)));
    f.count = untied;
    report.findings.push_back(std::move(f));
  });
}

}  // namespace

const Rule definition{{"GC209", "tie-by-part", Severity::note,
                       "a tie given by parts leaves nodes untied; a node set would say which are meant", Need::ties,
                       "It stays open which nodes are meant to tie"},
                      run};

}  // namespace gapcheck::audit::rule::tie_by_part
