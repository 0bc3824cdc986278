#include "solver/check_deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "contact/definition/active_time.hpp"
#include "contact/mesh/rigid_nodes.hpp"
#include "solver/condition/relaxation.hpp"
#include "solver/contact/contact_method.hpp"
#include "solver/contact/curve_rule.hpp"
#include "solver/tie/tie_strengths.hpp"

namespace gapcheck::solver {
namespace {

/// Why a side is empty; empty text: it is not.
std::string nothing_on(const contact::ContactSide& side, std::string_view name, bool as_reference) {
  const contact::Selection& selection = side.selection;
  if (!selection.segments.nodes.empty() || (!as_reference && !selection.nodes.empty())) return "";
  if (!selection.empty_reason.empty()) return fmt::format("{}: {}", name, selection.empty_reason);
  return fmt::format("{} has no {}", name, as_reference ? "segments" : "nodes");
}

std::string why_idle(const contact::ContactSurfaces& surfaces) {
  const bool one_side = surfaces.type.treatment == contact::Treatment::single_surface ||
                        surfaces.type.code == contact::ContactCode::single_edge;
  std::string why = nothing_on(surfaces.a, "SURFA", one_side);
  if (why.empty() && !one_side) why = nothing_on(surfaces.b, "SURFB", true);
  return why;
}

/// Constraint contacts move only nodes that follow nothing else.
SolverStatus no_rigid_nodes(const model::Model& model, const model::Contact& contact,
                            const contact::ContactSurfaces& surfaces) {
  const contact::RigidNodes rigid(model);
  const auto movable = [&](NodeIndex node) -> SolverStatus {
    const contact::RigidOwner owner = rigid.owner(node);
    if (!owner) return {};
    const std::string who = owner.kind == contact::RigidOwner::Kind::part
                                ? fmt::format("rigid part {}", model.parts[owner.index].id.value)
                                : "a nodal rigid body";
    return Failure{Failure::Kind::not_calculated,
                   fmt::format("contact {} (*{}) has node {} of {}, which its constraints cannot move; use a penalty "
                               "type, for instance {}",
                               contact.id.value, contact.written, model.mesh.nodes.id[node.value], who,
                               model::recommended_keyword(model::ContactCode::automatic_surface)),
                   contact.place};
  };
  for (const contact::ContactSide* side : {&surfaces.a, &surfaces.b}) {
    for (const NodeIndex node : side->nodes.node)
      if (SolverStatus status = movable(node); !status.ok()) return status;
    for (const auto& corners : side->selection.segments.nodes)
      for (const NodeIndex node : corners)
        if (SolverStatus status = movable(node); !status.ok()) return status;
  }
  return {};
}

/// An interface force database holds only sides that contacts name.
void name_missing_sides(const model::Model& model, Diagnostics& diagnostics) {
  const bool named = std::any_of(model.contacts.begin(), model.contacts.end(),
                                 [](const model::Contact& contact) { return contact.print_a || contact.print_b; });
  if (model.output.intfor > 0 && !named)
    diagnostics.warning(model.file(model.output.intfor_place), model.output.intfor_place.line,
                        "*DATABASE_BINARY_INTFOR: no intfor is written, since no contact has SAPR or SBPR = 1");
}

/// The curve that scales the stiffness of an INTERFERENCE contact.
SolverStatus check_interference(const model::Model& model, const model::Contact& contact, Diagnostics& diagnostics) {
  const auto warn = [&](const std::string& text) {
    diagnostics.warning("", 0, fmt::format("contact {}: {}", contact.id.value, text));
  };
  const auto fail = [&](const std::string& text) {
    return Failure{Failure::Kind::contradiction, fmt::format("contact {}: {}", contact.id.value, text), contact.place};
  };
  const auto check = [&](std::int64_t id, std::string_view field) -> SolverStatus {
    const auto curve = model.curves.find(id);
    if (curve == model.curves.end() || curve->second.points.empty())
      return fail(
          fmt::format("there is no curve {} ({}), or it has no points; define it with *DEFINE_CURVE", id, field));
    for (const auto& [time, factor] : curve->second.points)
      if (!std::isfinite(time) || !(factor >= 0) || !std::isfinite(factor))
        return fail(fmt::format("curve {} ({}) has the value {:g}, with which the contact pulls; use values from 0 up",
                                id, field, factor));
    return {};
  };
  if (const std::int64_t before = contact.interference_curve_relaxation; before != 0 && !relaxes(model))
    warn("LCID1 is not used: there is no dynamic relaxation before the run; LCID2 scales the stiffness");
  else if (before != 0)
    if (SolverStatus status = check(before, "LCID1"); !status.ok()) return status;
  if (contact.interference_curve == 0) {
    if (contact.interference_curve_relaxation == 0 || !relaxes(model))
      warn("LCID2 is not given: the whole stiffness acts at once; give a curve that grows from zero to one");
    return {};
  }
  return check(contact.interference_curve, "LCID2");
}

/// The curve of births and deaths.
SolverStatus check_times(const model::Model& model, const model::Contact& contact) {
  if (!contact::active_time(contact).by_curve) return {};
  const auto fail = [&](const std::string& text) {
    return Failure{Failure::Kind::contradiction, fmt::format("contact {}: {}", contact.id.value, text), contact.place};
  };
  const model::Curve* const curve = contact::times_curve(model, contact);
  if (curve == nullptr || curve->points.empty())
    return fail(
        fmt::format("DT = -9999 makes BT = {:g} the number of a curve, which is missing or has no points; define "
                    "it with *DEFINE_CURVE",
                    contact.birth));
  for (const auto& [birth, death] : curve->points)
    if (!std::isfinite(birth) || !(death > birth))
      return fail(
          fmt::format("curve {:g} (BT) has a death at {:g}, not after its birth at {:g}", contact.birth, death, birth));
  return {};
}

/// The cards of mortar contacts: what contradicts itself, and what is not calculated.
SolverStatus check_mortar(const model::Contact& contact, const contact::ContactSurfaces& surfaces,
                          Diagnostics& diagnostics) {
  const auto warn = [&](const std::string& text) {
    diagnostics.warning("", 0, fmt::format("contact {}: {}", contact.id.value, text));
  };
  const auto fail = [&](Failure::Kind kind, const std::string& text) {
    return Failure{kind, fmt::format("contact {} (*{}): {}", contact.id.value, contact.written, text), contact.place};
  };
  const std::int64_t ignore = surfaces.settings.ignore;
  const double mpar1 = contact.dprfac, mpar2 = contact.dtstif;
  if (ignore < -4 || ignore > 4)
    return fail(Failure::Kind::contradiction, fmt::format("IGNORE = {} has no meaning; use 0 to 4", ignore));
  const bool pressed_out = ignore == 3 || ignore == 4 || ignore == -3 || ignore == -4;
  if (!std::isfinite(mpar1) || !std::isfinite(mpar2))
    return fail(Failure::Kind::contradiction, "MPAR1 or MPAR2 is not a number");
  if (mpar1 < 0 && pressed_out)
    return fail(
        Failure::Kind::not_calculated,
        "an interference by a curve (MPAR1 below 0) is not calculated; give the time in which it is pressed out");
  if (mpar1 < 0)
    return fail(Failure::Kind::contradiction, fmt::format("the pressure MPAR1 = {:g} pulls; use 0 or more", mpar1));
  if (mpar2 < 0)
    return fail(Failure::Kind::contradiction, fmt::format("MPAR2 = {:g} is not a depth; use 0 or more", mpar2));
  if (pressed_out && mpar1 == 0) warn("MPAR1 = 0: the whole interference acts at once; give the time to press it out");
  if (contact.penmax < 0)
    return fail(Failure::Kind::contradiction,
                fmt::format("PENMAX = {:g} is not a length; use 0 or more", contact.penmax));
  if (contact.igap > 1) warn(fmt::format("IGAP = {}: the stiffness does not grow with the penetration", contact.igap));
  if (surfaces.two_sided() && contact.sfm != 1)
    warn("SFSB is not used: the stiffness is that of the faces of SURFA, scaled by SFSA");
  if (contact.sldthk > 0) warn("SLDTHK: faces of solids are not coated in mortar contacts");
  for (const contact::ContactSide* side : {&surfaces.a, &surfaces.b}) {
    if (side->nodes_only)
      warn("nodes without segments take no part in mortar contact; give the side as parts or segments");
    if (side->lines > 0) warn("beams take no part in mortar contact");
  }
  return {};
}

/// What moves nodes by constraints does not know of other equations between them.
SolverStatus check_linear(const model::Model& model, const model::Contact& contact, ContactMethod method,
                          const contact::ContactSurfaces& surfaces) {
  if (model.linear_constraints.empty() && model.joined_sets.empty()) return {};
  if (method != ContactMethod::constraint && !contact::ties_by_constraint(surfaces.type)) return {};
  return Failure{
      Failure::Kind::not_calculated,
      fmt::format("contact {} (*{}) acts by constraints, which is not calculated together with "
                  "*CONSTRAINED_LINEAR_GLOBAL, _LOCAL and _NODE_SET; use a penalty type or a tie with _OFFSET",
                  contact.id.value, contact.written),
      contact.place};
}

/// Contacts whose times or offsets in a dynamic relaxation are not known.
SolverStatus check_relaxation(const model::Contact& contact, ContactMethod method,
                              const contact::ContactSurfaces& surfaces) {
  const auto fail = [&](std::string_view why) {
    return Failure{Failure::Kind::not_calculated,
                   fmt::format("contact {} (*{}): {}", contact.id.value, contact.written, why), contact.place};
  };
  const bool timed = contact.birth != 0 || (contact.death != 0 && contact.death < 1e19);
  const std::int64_t ignore = std::abs(surfaces.settings.ignore);
  if (timed && method != ContactMethod::penalty)
    return fail(
        "births and deaths of ties and of contact by constraints are not calculated together with a dynamic "
        "relaxation; set BT and DT to 0");
  if (surfaces.type.pairing == contact::Pairing::mortar && (ignore == 3 || ignore == 4))
    return fail(
        "penetrations that mortar contact presses out over time (IGNORE = 3 and 4) are not calculated together "
        "with a dynamic relaxation; set IGNORE to 1 or 2");
  return {};
}

/// Settings of a contact that are calculated differently.
void name_differences(const model::Contact& contact, const contact::ContactSurfaces& surfaces,
                      Diagnostics& diagnostics) {
  const auto warn = [&](const std::string& text) {
    diagnostics.warning("", 0, fmt::format("contact {}: {}", contact.id.value, text));
  };
  if (contact.options.thermal) warn("THERMAL: heat does not flow through the contact");
  if (surfaces.type.pairing != contact::Pairing::segments) return;
  if (surfaces.settings.shlthk == 0)
    warn("SOFT = 2 holds shells apart by their thickness, which is left out here; set THKOPT = SHLTHK = 1 on card B");
  if (contact.sbopt == 4 || contact.sbopt == 5)
    warn(fmt::format("SBOPT = {}: the sliding option is not calculated; segments are curved patches in any case",
                     contact.sbopt));
  // The last digit says what is measured: 2 nodes, 5 edges too.
  const std::int64_t measured = contact.depth % 10;
  if (contact.depth != 0 && measured != 2 && measured != 5)
    warn(fmt::format("DEPTH = {}: depths are measured at the corners of segments, as with DEPTH = 2", contact.depth));
  if (contact.depth >= 10) warn(fmt::format("DEPTH = {}: only its last digit counts", contact.depth));
  if (contact.dtpchk < 0) warn("DTPCHK below 0: intersections are told, and the run goes on");
  if (contact.penmax > 0) warn("PENMAX has no meaning here: with SOFT = 2 no node is released");
}

}  // namespace

SolverStatus check_deck(const model::Model& model, contact::SurfaceStore& surfaces, Diagnostics& diagnostics) {
  const model::Controls& controls = model.controls;
  if (model.mesh.nodes.size() == 0)
    return Failure{Failure::Kind::empty, "the deck has no nodes, so there is nothing to calculate"};
  if (controls.tssfac < 0)
    return Failure{
        Failure::Kind::zero_time_step,
        fmt::format("TSSFAC of *CONTROL_TIMESTEP is {:g}; set a number above 0, at most 0.9", controls.tssfac)};
  const bool relaxing = relaxes(model);
  for (const ContactIndex c : positions<ContactIndex>(model.contacts.size())) {
    const model::Contact& contact = model.contact(c);
    const ContactMethod method = choose_method(contact).method;
    if (method == ContactMethod::none || method == ContactMethod::transducer) continue;
    if (method == ContactMethod::constraint)
      if (SolverStatus status = no_rigid_nodes(model, contact, surfaces.at(c)); !status.ok()) return status;
    if (controls.slsfac < 0)
      return Failure{Failure::Kind::contradiction,
                     fmt::format("SLSFAC of *CONTROL_CONTACT is {:g}, with which contacts pull; set a number above 0",
                                 controls.slsfac)};
    if (contact.sfs < 0 || contact.sfm < 0)
      return Failure{Failure::Kind::contradiction,
                     fmt::format("SFSA or SFSB of contact {} is below 0, so that it pulls; set a number above 0",
                                 contact.id.value),
                     contact.place};
    if (surfaces.at(c).type.pairing == contact::Pairing::mortar)
      if (SolverStatus status = check_mortar(contact, surfaces.at(c), diagnostics); !status.ok()) return status;
    if (surfaces.at(c).type.can(contact::Ability::interference))
      if (SolverStatus status = check_interference(model, contact, diagnostics); !status.ok()) return status;
    if (acts_by_curve(contact))
      if (SolverStatus status = check_curve_contact(model, contact); !status.ok()) return status;
    if (SolverStatus status = check_times(model, contact); !status.ok()) return status;
    if (SolverStatus status = check_linear(model, contact, method, surfaces.at(c)); !status.ok()) return status;
    if (relaxing)
      if (SolverStatus status = check_relaxation(contact, method, surfaces.at(c)); !status.ok()) return status;
    if (SolverStatus status = check_tie_strength(model, contact, diagnostics); !status.ok()) return status;
    name_differences(contact, surfaces.at(c), diagnostics);
    if (const std::string why = why_idle(surfaces.at(c)); !why.empty())
      diagnostics.warning("", 0, fmt::format("contact {} does nothing ({}); correct its sides", contact.id.value, why));
  }
  name_missing_sides(model, diagnostics);
  return {};
}

}  // namespace gapcheck::solver
