#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>

#include "audit/rules.hpp"
#include "audit/shared/contact_thickness.hpp"
#include "contact/pair/pair.hpp"
#include "contact/pair/release.hpp"

namespace gapcheck::audit::rule::solid_early_release {
namespace {

constexpr std::array thresholds{
    Threshold{"share-of-shells", 0.5, 0, 1e6,
              "share of the release depth of the thinnest shells, below which solids are listed"}};
/// If a contact has no shells to compare with: share of the facet's shortest edge.
constexpr double least_share_of_edge = 0.1;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The release depths of one contact.
class Releases {
 public:
  Releases(const model::Model& model, const model::Contact& contact, const contact::ContactSurfaces& surfaces,
           double share_of_shells)
      : model_(model), contact_(contact), surfaces_(surfaces), share_of_shells_(share_of_shells) {
    double thinnest = infinity;
    const contact::Segments& s = surfaces.a.selection.segments;
    for (std::size_t i = 0; i < s.size(); ++i)
      if (s.kind[i] == contact::SegmentKind::shell && s.half[i] > 0) thinnest = std::min(thinnest, 2 * s.half[i]);
    if (thinnest == infinity) return;
    contact::ReleasePair pair;
    pair.node_thickness = pair.segment_thickness = thinnest;
    shells_ = depth(pair);
  }
  [[nodiscard]] bool any_shells() const { return shells_ < infinity; }
  [[nodiscard]] double solid(std::size_t i) const {
    contact::ReleasePair pair;
    pair.solid_segment = true;
    pair.solid_depth = contact::solid_depth(surfaces_.a.selection.segments, model_.mesh, i, model_.mesh.nodes.x);
    return depth(pair);
  }
  [[nodiscard]] double shells() const { return shells_; }
  /// Depth that a solid should bear at least.
  [[nodiscard]] double least(std::size_t i) const {
    if (any_shells()) return share_of_shells_ * shells_;
    return least_share_of_edge * contact::shortest_edge(surfaces_.a.selection.segments.nodes[i], model_.mesh.nodes.x);
  }

 private:
  [[nodiscard]] double depth(const contact::ReleasePair& pair) const {
    return contact::release_depth(contact_, surfaces_.type, surfaces_.settings, model_.controls, pair);
  }
  const model::Model& model_;
  const model::Contact& contact_;
  const contact::ContactSurfaces& surfaces_;
  double share_of_shells_, shells_ = infinity;
};

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const model::Model& model = context.model();
  std::vector<PartSegments> parts;
  std::map<ContactIndex, Releases> of_contact;
  for (const ContactIndex c : contacts_with_thickness(rule, context)) {
    const model::Contact& contact = model.contact(c);
    const contact::ContactType type = contact::classify(contact);
    // Types 26 release at 200 thicknesses: in effect never.
    if (type.treatment != contact::Treatment::single_surface || type.edges || !type.checked()) continue;
    const contact::ContactSurfaces& surfaces = context.surfaces(c);
    const contact::Segments& s = surfaces.a.selection.segments;
    if (std::find(s.kind.begin(), s.kind.end(), contact::SegmentKind::solid) == s.kind.end()) continue;
    const Releases& releases =
        of_contact.try_emplace(c, model, contact, surfaces, context.threshold(rule, thresholds[0])).first->second;
    weigh_by_part(parts, context, c, s, [&](std::size_t i) {
      if (s.kind[i] != contact::SegmentKind::solid) return 0.0;
      const double depth = releases.solid(i), least = releases.least(i);
      return depth < least ? least / depth : 0.0;
    });
  }
  const auto words = [&](const PartSegments& p) {
    const Releases& releases = of_contact.at(p.contact);
    const std::uint32_t worst = p.worst.item;
    const std::string against = releases.any_shells()
                                    ? fmt::format("the thinnest shells hold to {:.4g}", releases.shells())
                                    : fmt::format("a tenth of its shortest edge is {:.4g}", releases.least(worst));
    return fmt::format(
        "{}: {} release nodes early, {} worst: at a depth of {:.4g}, where {}; coat the solids with SLDTHK on card B",
        part_name(model, p.part()), count_elements(p.worst.count), element_name(model.mesh, *p.segments, worst),
        releases.solid(worst), against);
  };
  add_by_part(rule, context, report, parts, words, "parts whose solids release nodes early");
}

}  // namespace

const Rule definition{.identity = {"GC306", "solid-early-release", Severity::warning,
                                   "a single-surface contact gives up on nodes in thin solids before it does in shells",
                                   Need::surfaces, "Nodes that enter thin solids are given up early and pass through"},
                      .run = run,
                      .thresholds = thresholds};

}  // namespace gapcheck::audit::rule::solid_early_release
