#include <fmt/format.h>

#include "audit/rules.hpp"
#include "audit/shared/tied_contacts.hpp"

namespace gapcheck::audit::rule::tie_reach {
namespace {

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const model::Model& model = context.model();
  for_each_tied_contact(context, [&](ContactIndex c, std::span<const contact::JudgedNode> nodes) {
    const auto far = far_nodes(model, nodes);
    if (!far) return;
    const std::int64_t id = model.mesh.nodes.id[far->farthest->node.value];
    Finding f = finding_at(
        rule, context, model.contact(c),
        fmt::format(
            "{} too far to tie, node {} by most: {:.6g} from its segment, tie distance {:.6g}; SST = {:.6g} would "
            "tie {} and all that tie now",
            far->count == 1 ? "1 node is" : fmt::format("{} nodes are", far->count), id, far->farthest->distance,
            far->farthest->allowed, -far->reach, far->count == 1 ? "it" : "them"));
    f.node = id;
    f.count = far->count;
    report.findings.push_back(std::move(f));
  });
}

}  // namespace

const Rule definition{
    {"GC208", "tie-reach", Severity::note, "the negative SST that would tie the nodes that are too far", Need::ties,
     "The nodes stay untied as long as the reach is too short"},
    run};

}  // namespace gapcheck::audit::rule::tie_reach
