#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "audit/members.hpp"
#include "audit/rules.hpp"
#include "audit/shared/mesh_finding.hpp"

namespace gapcheck::audit::rule::uneven_mesh {
namespace {

constexpr std::array thresholds{Threshold{
    "ratio", 5, 1, 1e6, "ratio of the sizes of two segments with a common edge, above which they are listed"}};

std::uint64_t pack(std::size_t larger, std::size_t smaller) {
  return static_cast<std::uint64_t>(larger) << 32 | smaller;
}

/// True if sizes differ enough anywhere; otherwise there is no need to search for neighbours.
bool sizes_differ(const std::vector<contact::SegmentQuality>& quality, float largest_ratio) {
  float smallest = std::numeric_limits<float>::max(), largest = 0;
  for (const contact::SegmentQuality& q : quality) {
    if (q.fault != contact::SegmentFault::none) continue;
    smallest = std::min(smallest, q.size);
    largest = std::max(largest, q.size);
  }
  return largest > largest_ratio * smallest;
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  contact::ContactMesh* mesh = mesh_in_contact(rule, context);
  if (mesh == nullptr) return;
  const auto& quality = mesh->quality();
  const auto largest_ratio = static_cast<float>(context.threshold(rule, thresholds[0]));
  if (!sizes_differ(quality, largest_ratio)) return;
  mesh->build_edges();
  const auto ratio = [&](std::size_t larger, std::size_t smaller) {
    return quality[larger].size / quality[smaller].size;
  };
  std::vector<Found> found =
      find_all(context.model().mesh.nodes.size(), [&](std::size_t node, std::vector<Found>& list) {
        const auto uses = mesh->edges_at(node);
        for (std::size_t i = 0; i < uses.size(); ++i)
          for (std::size_t j = i + 1; j < std::min(uses.size(), i + contact::most_uses); ++j) {
            if (uses[i].other != uses[j].other) continue;
            std::size_t larger = uses[i].segment, smaller = uses[j].segment;
            if (quality[larger].size < quality[smaller].size) std::swap(larger, smaller);
            if (quality[larger].fault != contact::SegmentFault::none ||
                quality[smaller].fault != contact::SegmentFault::none)
              continue;
            if (!(quality[larger].size > largest_ratio * quality[smaller].size)) continue;
            // The sides of a thin brick are smaller than its face, and nothing is wrong with that.
            if (mesh->same_element(larger, smaller) || mesh->only_tied(larger) || mesh->only_tied(smaller)) continue;
            const PartIndex a = mesh->part(larger), b = mesh->part(smaller);
            if (context.part_chosen(a) || context.part_chosen(b))
              list.push_back({part_pair(a, b), ratio(larger, smaller), pack(larger, smaller)});
          }
      });
  add_grouped(
      report, std::move(found),
      [&](const Found& f) {
        const std::size_t larger = f.item >> 32, smaller = f.item & 0xFFFFFFFFU;
        return segment_finding(
            rule, context, *mesh, larger,
            fmt::format("{}{} is {:.3g} times as large as {}{} beside it (sizes {:.3g} and {:.3g}, limit {}); "
                        "refine in steps",
                        segment_name(*mesh, larger), of_part(*mesh, larger), f.weight, segment_name(*mesh, smaller),
                        of_part(*mesh, smaller), quality[larger].size, quality[smaller].size, largest_ratio));
      },
      [&](const Found& f, std::uint64_t count) {
        return segments_finding(
            rule, context, *mesh, f.item >> 32,
            fmt::format("{} more pairs of neighbours{} differ in size by more than {} times, up to {:.3g}", count,
                        of_part(*mesh, f.item >> 32), largest_ratio, f.weight));
      },
      collect_segments(context, [&](const Found& f, const auto& add) {
        add(mesh->nodes(f.item >> 32));
        add(mesh->nodes(f.item & 0xFFFFFFFFU));
      }));
}

}  // namespace

const Rule definition{
    .identity = {"GC511", "uneven-mesh", Severity::note, "neighbouring segments in contact differ much in size",
                 Need::surfaces, "Contact forces are uneven where sizes jump"},
    .run = run,
    .thresholds = thresholds};

}  // namespace gapcheck::audit::rule::uneven_mesh
