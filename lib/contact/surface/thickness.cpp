#include "contact/surface/thickness.hpp"

#include <algorithm>
#include <cmath>

namespace gapcheck::contact {
namespace {

/// SSTHK = 0: share of the shortest edge that a single-surface thickness may reach (contact rules, section 4.3).
constexpr double edge_share = 0.4;

}  // namespace

double scale_of(const model::PartContact* part, const ThicknessSide& side) {
  const bool own = part != nullptr && part->sft != 0;
  return (own ? part->sft : side.scale) * side.global_scale;
}

ThicknessSide thickness_side(const model::Contact& contact, const ContactSettings& settings,
                             const model::Controls& controls, bool side_b) {
  ThicknessSide side;
  side.override_value = std::abs(side_b ? contact.mst : contact.sst);
  if (contact.airbag_thickness > 0) side.override_value = contact.airbag_thickness;
  const double scale = side_b ? contact.sfmt : contact.sfst;
  side.scale = scale != 0 ? scale : 1;
  side.global_value = controls.th;
  side.global_scale = controls.th_sf != 0 ? controls.th_sf : 1;
  side.solid_coating = contact.sldthk;
  // IGNROFF: 1 for side B, 2 for side A (contact rules, section 4.4).
  const bool ignored = contact.ignroff == 3 || contact.ignroff == (side_b ? 1 : 2);
  side.shlthk = ignored ? 0 : settings.shlthk;
  side.edge_limit = settings.thickness_limit;
  return side;
}

ThicknessSide changed(ThicknessSide side, const ThicknessChange& change) {
  if (change.own) {
    side.optt = false;
    side.override_value = side.global_value = 0;
  }
  if (change.card != 0) side.override_value = change.card;
  return side;
}

Thickness shell_thickness(double element, double shortest_edge, const model::PartContact* part, bool rigid,
                          const ThicknessSide& side) {
  if (side.shlthk == 0 || (side.shlthk == 1 && rigid)) return {};
  if (side.optt && part != nullptr && part->optt != 0) return {std::abs(part->optt), ThicknessRule::part_contact};
  if (side.override_value != 0) return {side.override_value, ThicknessRule::contact_card};
  if (side.global_value != 0) return {side.global_value, ThicknessRule::global};
  const double scaled = element * scale_of(part, side);
  const double limit = edge_share * shortest_edge;
  if (side.edge_limit && limit < scaled) return {limit, ThicknessRule::edge_limit};
  return {scaled, scaled > 0 ? ThicknessRule::element : ThicknessRule::none};
}

Thickness solid_thickness(const ThicknessSide& side) {
  if (side.solid_coating > 0) return {side.solid_coating, ThicknessRule::solid_coating};
  return {};
}

Thickness beam_thickness(double radius, const model::PartContact* part, const ThicknessSide& side) {
  if (side.optt && part != nullptr && part->optt != 0) return {std::abs(part->optt), ThicknessRule::part_contact};
  if (side.override_value != 0) return {side.override_value, ThicknessRule::contact_card};
  if (side.global_value != 0) return {side.global_value, ThicknessRule::global};
  const double scaled = 2 * radius * scale_of(part, side);
  return {scaled, scaled > 0 ? ThicknessRule::beam_section : ThicknessRule::none};
}

double element_thickness(const model::Model& model, std::uint32_t shell) {
  const auto& shells = model.mesh.shells;
  std::array<double, 4> thickness{};
  const PartIndex part = shells.part[shell];
  if (part != none<PartIndex>) {
    const model::Part& p = model.part(part);
    if (p.composite_thickness > 0) return p.composite_thickness;
    if (p.section) thickness = model.sections[*p.section].thickness;
  }
  const auto own = std::lower_bound(shells.own_thickness.begin(), shells.own_thickness.end(), shell,
                                    [](const model::ShellThickness& t, std::uint32_t s) { return t.shell < s; });
  if (own != shells.own_thickness.end() && own->shell == shell) {
    for (std::size_t i = 0; i < 4; ++i)
      if (own->thickness[i] > 0) thickness[i] = own->thickness[i];
  }
  const auto& nodes = shells.nodes[shell];
  const std::size_t corners = nodes[2] == nodes[3] ? 3 : 4;
  double sum = 0;
  for (std::size_t i = 0; i < corners; ++i) sum += thickness[i];
  return sum / static_cast<double>(corners);
}

double mid_surface_offset(const model::Model& model, std::uint32_t shell) {
  const auto& shells = model.mesh.shells;
  const auto own = std::lower_bound(shells.own_offset.begin(), shells.own_offset.end(), shell,
                                    [](const model::ShellOffset& o, std::uint32_t s) { return o.shell < s; });
  if (own != shells.own_offset.end() && own->shell == shell) return own->offset;
  const PartIndex part = shells.part[shell];
  if (part == none<PartIndex> || !model.part(part).section) return 0;
  const double nloc = model.sections[*model.part(part).section].nloc;
  return nloc == 0 ? 0 : -nloc * element_thickness(model, shell) / 2;
}

}  // namespace gapcheck::contact
