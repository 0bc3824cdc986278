#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/condition/preload_curve.hpp"
#include "solver/condition/section_plane.hpp"

namespace gapcheck::solver {
namespace {

constexpr std::string_view section_keyword = "INITIAL_STRESS_SECTION";

/// Which solids a cross-section has, and what of them lies in front of it.
class SectionCut {
 public:
  SectionCut(ConditionBuilder& builder, const model::SectionPreload& preload, const model::CrossSection& section)
      : builder_(builder), preload_(preload), section_(section) {}

  /// The unit normal; nothing after a failure.
  std::optional<Vector> normal() {
    Vector direction = section_.normal;
    if (preload_.vector != 0) {
      const auto found = builder_.model.vectors.find(preload_.vector);
      if (found == builder_.model.vectors.end()) {
        fail(Failure::Kind::unknown_reference,
             fmt::format("vector {} is not defined by a *DEFINE_VECTOR; define it", preload_.vector));
        return std::nullopt;
      }
      builder_.refuse_system(found->second.system, section_keyword, preload_.place);
      direction = found->second.direction;
    } else if (!section_.plane) {
      fail(Failure::Kind::contradiction,
           fmt::format("section {} is given by sets and has no normal; name a *DEFINE_VECTOR (VID)", section_.id));
      return std::nullopt;
    }
    const double length = direction.norm();
    if (!(length > 0) || !std::isfinite(length)) {
      fail(Failure::Kind::contradiction, fmt::format("the normal of section {} has no direction", section_.id));
      return std::nullopt;
    }
    return Vector(direction / length);
  }

  /// Its solids by their positions in the model, ascending; empty after a failure.
  std::vector<std::uint32_t> solids() {
    const model::Mesh& mesh = builder_.model.mesh;
    std::vector<std::uint32_t> result;
    if (!section_.plane) {
      const auto set = builder_.model.sets.solids.find(section_.solids);
      if (set == builder_.model.sets.solids.end())
        fail(Failure::Kind::unknown_reference,
             fmt::format("section {} has no set of solids (HSID = {}); define it", section_.id, section_.solids));
      else
        result = set->second.members;
    } else if (find_limits()) {
      for (std::uint32_t i = 0; i < mesh.solids.size(); ++i)
        if (cuts(mesh.solids.nodes[i])) result.push_back(i);
    }
    for (const std::int64_t parts : {preload_.parts, section_.parts}) keep(parts, result);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    if (result.empty())
      fail(Failure::Kind::contradiction,
           fmt::format("section {} has no solids of the parts that PSID names; move the plane or correct the sets",
                       section_.id));
    return builder_.failed() ? std::vector<std::uint32_t>() : result;
  }

  /// The corners in front of the plane, or of the solid's centre where sets give the section; one bit each.
  [[nodiscard]] std::uint8_t front(const std::array<NodeIndex, 8>& nodes, const Vector& normal) const {
    const Vector from = section_.plane ? section_.tail : centre(nodes);
    unsigned bits = 0;
    for (std::size_t k = 0; k < 8; ++k)
      if ((x(nodes[k]) - from).dot(normal) > 0) bits |= 1u << k;
    return static_cast<std::uint8_t>(bits);
  }

 private:
  void fail(Failure::Kind kind, std::string_view message) {
    builder_.fail(kind, section_keyword, preload_.place, message);
  }
  [[nodiscard]] const Vector& x(NodeIndex node) const { return builder_.structure.state.x[node.value]; }

  [[nodiscard]] Vector centre(const std::array<NodeIndex, 8>& nodes) const {
    Vector sum = Vector::Zero();
    for (const NodeIndex node : nodes) sum += x(node);
    return sum / 8;
  }

  /// Radius and edges of the plane; false after a failure.
  bool find_limits() {
    const std::string fault = SectionPlane::fault(section_);
    if (!fault.empty()) fail(Failure::Kind::contradiction, fault);
    if (fault.empty()) plane_.emplace(section_);
    return fault.empty();
  }

  /// Corners on both sides of the plane, and the centre within the limits.
  [[nodiscard]] bool cuts(const std::array<NodeIndex, 8>& nodes) const {
    return plane_->parts(nodes, [&](NodeIndex node) -> const Vector& { return x(node); }) &&
           plane_->within(centre(nodes));
  }

  void keep(std::int64_t parts, std::vector<std::uint32_t>& solids) {
    if (parts == 0 || builder_.failed()) return;
    std::vector<bool> wanted(builder_.model.parts.size());
    for (const PartIndex part : builder_.part_set(parts, section_keyword, preload_.place)) wanted[part.value] = true;
    const auto other = [&](std::uint32_t solid) {
      const PartIndex part = builder_.model.mesh.solids.part[solid];
      return part.value >= wanted.size() || !wanted[part.value];
    };
    solids.erase(std::remove_if(solids.begin(), solids.end(), other), solids.end());
  }

  ConditionBuilder& builder_;
  const model::SectionPreload& preload_;
  const model::CrossSection& section_;
  std::optional<SectionPlane> plane_;
};

/// The section that a preload names; nullptr after a failure.
const model::CrossSection* section_of(ConditionBuilder& builder, const model::SectionPreload& preload) {
  const model::CrossSection* result = nullptr;
  for (const model::CrossSection& section : builder.model.cross_sections) {
    if (section.id != preload.section) continue;
    if (result != nullptr)
      builder.fail(Failure::Kind::contradiction, section_keyword, preload.place,
                   fmt::format("there are two cross-sections {}; give one another id", section.id));
    result = &section;
  }
  if (result == nullptr)
    builder.fail(Failure::Kind::unknown_reference, section_keyword, preload.place,
                 fmt::format("cross-section {} is not defined by a *DATABASE_CROSS_SECTION_PLANE or _SET; define it",
                             preload.section));
  return builder.failed() ? nullptr : result;
}

/// Why a solid cannot be preloaded; empty: it can.
std::string_view why_not(const SolidElements& solids, std::uint32_t position) {
  if (position == no_position) return "is rigid";
  const Material& material = solids.properties(position).material;
  if (!material.has_stress()) return "has a material without stress";
  if (material.kind == MaterialKind::rubber) return "is of rubber, whose stress follows from its deformation";
  if (material.kind == MaterialKind::hydro) return "has an equation of state, from which its pressure follows";
  return "";
}

void apply_section_preload(ConditionBuilder& builder, const model::SectionPreload& preload,
                           const std::vector<std::uint32_t>& positions) {
  const auto fail = [&](Failure::Kind kind, std::string_view message) {
    builder.fail(kind, section_keyword, preload.place, message);
  };
  if (preload.shear != 0 && preload.shear != 1)
    fail(Failure::Kind::not_calculated, fmt::format("IZSHEAR = {} is not calculated; 0 and 1 are", preload.shear));
  if (preload.ghost != 0)
    fail(Failure::Kind::not_calculated, "an artificial stiffness (ISTIFF) is not calculated; set it to 0");
  const model::CrossSection* section = section_of(builder, preload);
  if (section == nullptr) return;
  constexpr PreloadWords words{section_keyword, "", "stress", "stresses", "solids"};
  const auto curve = preload_curve(builder, preload.curve, preload.scale, words, preload.place);
  SectionCut cut(builder, preload, *section);
  const std::optional<Vector> normal = cut.normal();
  if (builder.failed() || !curve || !normal) return;
  SolidElements& solids = builder.structure.solids;
  const double stress = curve->curve.at(curve->end);
  SectionStress result{section->id, curve->curve, curve->end, {*normal, 0, preload.shear == 1}, {}, curve->phases};
  bool yields = false;
  for (const std::uint32_t member : cut.solids()) {
    const std::int64_t id = builder.model.mesh.solids.id[member];
    const std::uint32_t position = positions[member];
    if (const std::string_view why = why_not(solids, position); !why.empty())
      return fail(Failure::Kind::not_calculated, fmt::format("solid {} {}; leave it out of the section", id, why));
    if (solids.section_of(position) != no_position)
      return fail(Failure::Kind::contradiction, fmt::format("solid {} has two preloads; give it one", id));
    const Material& material = solids.properties(position).material;
    if (stress > material.young)
      return fail(Failure::Kind::contradiction,
                  fmt::format("the stress {:g} is beyond Young's modulus {:g} of solid {}; look at its unit", stress,
                              material.young, id));
    yields = yields || (material.kind == MaterialKind::plastic && stress > material.yield_at(0).stress(0));
    result.solids.emplace_back(position, cut.front(builder.model.mesh.solids.nodes[member], *normal));
  }
  if (builder.failed()) return;
  if (yields)
    builder.warn(
        section_keyword, preload.place,
        fmt::format("the stress {:g} is above the yield stress; solids will yield once the curve has ended", stress));
  solids.add_section(std::move(result));
}

}  // namespace

void apply_section_preloads(ConditionBuilder& builder) {
  if (builder.model.section_preloads.empty()) return;
  std::vector<std::uint32_t> positions(builder.model.mesh.solids.size(), no_position);
  const SolidElements& solids = builder.structure.solids;
  for (std::uint32_t i = 0; i < solids.size(); ++i) positions[solids.origin(i)] = i;
  for (const model::SectionPreload& preload : builder.model.section_preloads)
    if (!builder.failed()) apply_section_preload(builder, preload, positions);
}

}  // namespace gapcheck::solver
