#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/condition/condition_builder.hpp"

namespace gapcheck::solver {
namespace {

using model::InitialStress;

std::string_view keyword_of(const InitialStress& one) {
  switch (one.kind) {
    case InitialStress::Kind::shell_set:
      return "INITIAL_STRESS_SHELL_SET";
    case InitialStress::Kind::solid:
      return "INITIAL_STRESS_SOLID";
    case InitialStress::Kind::solid_set:
      return "INITIAL_STRESS_SOLID_SET";
    case InitialStress::Kind::shell:
      break;
  }
  return "INITIAL_STRESS_SHELL";
}

Symmetric symmetric(const std::array<double, 6>& stress) { return stress; }  // the same order of components

double largest(const Symmetric& stress) {
  double most = 0;
  for (const double value : stress) most = std::max(most, std::abs(value));
  return most;
}

/// What is reported once for all elements: how many, and the first of them.
struct Tally {
  std::size_t count = 0;
  const InitialStress* first = nullptr;
  std::int64_t element = 0;
  void add(const InitialStress& one, std::int64_t id) {
    if (count++ == 0) first = &one, element = id;
  }
};

/// Checks all entries and gives their points to the elements.
class InitialStresses {
 public:
  explicit InitialStresses(ConditionBuilder& builder)
      : builder_(builder),
        shells_(positions(builder.structure.shells, builder.model.mesh.shells.size())),
        solids_(positions(builder.structure.solids, builder.model.mesh.solids.size())) {}

  void apply() {
    for (const InitialStress& one : builder_.model.initial_stresses) {
      if (!builder_.failed()) check_cards(one);
      if (!builder_.failed()) give(one);
      if (builder_.failed()) return;
    }
    warn(history_, "history variables (NHISV) are not used: the material keeps stress and plastic strain only");
    warn(across_, "the stress across the shell is left out: shells have none");
    warn(outside_, "the stress is beyond the yield stress; the element flows in its first step");
  }

 private:
  /// By position in the model: position in the structure.
  template <class Elements>
  static std::vector<std::uint32_t> positions(const Elements& elements, std::size_t count) {
    std::vector<std::uint32_t> result(count, no_position);
    for (std::uint32_t i = 0; i < elements.size(); ++i) result[elements.origin(i)] = i;
    return result;
  }

  void fail(const InitialStress& one, Failure::Kind kind, std::string_view message) {
    builder_.fail(kind, keyword_of(one), one.place, message);
  }

  void warn(const Tally& tally, std::string_view what) {
    if (tally.count == 0) return;
    const std::string others = tally.count > 1 ? fmt::format(" and {} other elements", tally.count - 1) : "";
    builder_.warn(keyword_of(*tally.first), tally.first->place,
                  fmt::format("element {}{}: {}", tally.element, others, what));
  }

  static bool of_shells(const InitialStress& one) {
    return one.kind == InitialStress::Kind::shell || one.kind == InitialStress::Kind::shell_set;
  }
  static bool of_set(const InitialStress& one) {
    return one.kind == InitialStress::Kind::shell_set || one.kind == InitialStress::Kind::solid_set;
  }

  /// What can be said without the element.
  void check_cards(const InitialStress& one) {
    const std::string who = fmt::format("{} {}", of_set(one) ? "set" : of_shells(one) ? "shell" : "solid", one.id);
    const auto not_calculated = [&](std::string_view what) {
      fail(one, Failure::Kind::not_calculated, fmt::format("{}: {}", who, what));
    };
    const auto contradiction = [&](const std::string& what) {
      fail(one, Failure::Kind::contradiction, fmt::format("{}: {}", who, what));
    };
    if (one.tensors != 0)
      not_calculated("tensors among the history variables (NTENSR) are not calculated; set it to 0");
    if (one.thermal != 0) not_calculated("thermal history variables (NTHINT, NTHHSV) are not calculated; remove them");
    if (one.volume_flag != 0) not_calculated("an initial volume or energy (IVEFLG) is not calculated; set it to 0");
    if (one.group != 0) not_calculated("multi-material elements (IALEGP) are not calculated; set it to 0");
    if (one.turned)
      not_calculated(
          "the *INCLUDE_TRANSFORM of its file turns or mirrors the mesh, but not these stresses; give them "
          "in the axes of the model, in a file that is not turned");
    if (one.large != 0 && one.large != 1) contradiction(fmt::format("LARGE is {}; use 0 or 1", one.large));
    if (one.history < 0) contradiction(fmt::format("NHISV is {}; use 0 or more", one.history));
    if (!of_shells(one) && one.large == 0 && one.history != 0)
      contradiction(fmt::format("NHISV is {} without LARGE = 1, which history variables of solids need", one.history));
    if (!one.readable())
      contradiction(
          of_shells(one)
              ? fmt::format("{} points in the plane (NPLANE) and {} layers (NTHICK) with {} history variables "
                            "cannot be read; correct the numbers",
                            one.in_plane, one.layers, one.history)
              : fmt::format("{} points (NINT) with {} history variables cannot be read; correct the numbers",
                            one.in_plane, one.history));
    if (!one.complete())
      contradiction(fmt::format("the deck has {} of its {} points; add the missing cards", one.points.size(),
                                one.in_plane * one.layers));
  }

  void give(const InitialStress& one) {
    const model::Mesh& mesh = builder_.model.mesh;
    const bool shells = of_shells(one);
    const auto give_one = [&](std::uint32_t element) {
      if (builder_.failed()) return;
      if (shells)
        give_shell(one, element);
      else
        give_solid(one, element);
    };
    if (!of_set(one)) {
      const auto found = shells ? mesh.shells.lookup.find(one.id) : mesh.solids.lookup.find(one.id);
      if (found) return give_one(*found);
      return fail(one, Failure::Kind::unknown_reference,
                  fmt::format("{} {} does not exist; remove its stress", shells ? "shell" : "solid", one.id));
    }
    const auto& sets = shells ? builder_.model.sets.shells : builder_.model.sets.solids;
    const auto set = sets.find(one.id);
    if (set == sets.end() || set->second.members.empty())
      return fail(one, Failure::Kind::unknown_reference,
                  fmt::format("there is no set {} with {}; define it", one.id, shells ? "shells" : "solids"));
    for (const std::uint32_t element : set->second.members) give_one(element);
  }

  /// The element's position in the structure; none after a failure. `given`: by that position, who has a stress.
  std::uint32_t position(const InitialStress& one, std::string_view what, std::int64_t id, std::uint32_t position,
                         std::vector<bool>& given) {
    if (position == no_position) {
      fail(one, Failure::Kind::contradiction,
           fmt::format("{} {} is rigid and has no stress; remove the card", what, id));
      return no_position;
    }
    if (position >= given.size()) given.resize(std::size_t{position} + 1);
    if (given[position]) {
      fail(one, Failure::Kind::contradiction, fmt::format("{} {} has two start stresses; give it one", what, id));
      return no_position;
    }
    given[position] = true;
    return position;
  }

  void give_shell(const InitialStress& one, std::uint32_t element) {
    const std::int64_t id = builder_.model.mesh.shells.id[element];
    ShellElements& shells = builder_.structure.shells;
    const std::uint32_t shell = position(one, "shell", id, shells_[element], given_shells_);
    if (shell == no_position) return;
    const ShellProperties& properties = shells.properties(shell);
    const std::size_t layers = properties.layers.size(), in_plane = shells.points_in_plane(shell);
    if (one.in_plane != static_cast<std::int64_t>(in_plane) || one.layers != static_cast<std::int64_t>(layers))
      return fail(one, Failure::Kind::contradiction,
                  fmt::format("shell {} has {} points in the plane and {} layers, but NPLANE is {} and NTHICK {}; give "
                              "as many as it has",
                              id, in_plane, layers, one.in_plane, one.layers));
    const Matrix axes = shells.axes(shell, builder_.structure.state.x);
    std::vector<PointState> points(in_plane * layers);
    std::vector<bool> found(layers);
    double across = 0, most = 0;
    for (std::size_t given = 0; given < layers; ++given) {
      const std::size_t layer = layer_at(one.points[given * in_plane].place, properties.layers);
      if (layer == layers || found[layer]) return fail_layers(one, id, given * in_plane, properties);
      found[layer] = true;
      for (std::size_t i = 0; i < in_plane; ++i) {
        const model::StressPoint& written = one.points[given * in_plane + i];
        if (layer_at(written.place, properties.layers) != layer)
          return fail_layers(one, id, given * in_plane + i, properties);
        PointState& point = points[i * layers + layer];
        point.stress = rotated(symmetric(written.stress), axes.transpose());
        point.plastic_strain = written.plastic_strain;
        most = std::max(most, largest(point.stress));
        across = std::max(across, std::abs(std::exchange(point.stress[zz], 0.0)));
      }
    }
    // Rounded files have a thousandth of it.
    if (across > 0.1 * most)
      return fail(one, Failure::Kind::contradiction,
                  fmt::format("shell {} gets a stress of {:g} across it, which shells do not have; give the components "
                              "in global axes",
                              id, across));
    if (across > 1e-3 * most) across_.add(one, id);
    if (check_points(one, id, properties.material, points, true)) shells.begin_with(shell, points, x());
  }

  /// The layer whose place is T; their number if there is none.
  static std::size_t layer_at(double place, const std::vector<GaussPoint>& layers) {
    constexpr double rounding = 2e-3;  // files give three digits or more
    const auto found = std::find_if(layers.begin(), layers.end(),
                                    [&](const GaussPoint& layer) { return std::abs(layer.place - place) <= rounding; });
    return static_cast<std::size_t>(found - layers.begin());
  }

  void fail_layers(const InitialStress& one, std::int64_t id, std::size_t row, const ShellProperties& properties) {
    std::string places;
    for (const GaussPoint& layer : properties.layers)
      places += fmt::format("{}{:.5f}", places.empty() ? "" : ", ", layer.place);
    fail(one, Failure::Kind::contradiction,
         fmt::format("shell {}: T = {:g} of its point {} fits no layer, or one that it has already; its layers are at "
                     "{}, each with all points of the plane in a row",
                     id, one.points[row].place, row + 1, places));
  }

  void give_solid(const InitialStress& one, std::uint32_t element) {
    const std::int64_t id = builder_.model.mesh.solids.id[element];
    SolidElements& solids = builder_.structure.solids;
    const std::uint32_t solid = position(one, "solid", id, solids_[element], given_solids_);
    if (solid == no_position) return;
    if (solids.rule(solid) == SolidRule::wedge)
      return fail(one, Failure::Kind::not_calculated,
                  fmt::format("solid {} is a wedge of eight points, whose stresses are not read; use ELFORM 1", id));
    const std::size_t count = has_eight_points(solids.rule(solid)) ? 8 : 1;
    if (one.in_plane != static_cast<std::int64_t>(count))
      return fail(
          one, Failure::Kind::contradiction,
          fmt::format("solid {} has {} points, but NINT is {}; give as many as it has", id, count, one.in_plane));
    std::vector<PointState> points(count);
    for (std::size_t i = 0; i < count; ++i) {
      points[i].stress = symmetric(one.points[i].stress);
      points[i].plastic_strain = one.points[i].plastic_strain;
    }
    if (check_points(one, id, solids.properties(solid).material, points, false)) solids.begin_with(solid, points, x());
  }

  /// What the material can begin with; false after a failure.
  bool check_points(const InitialStress& one, std::int64_t id, const Material& material,
                    const std::vector<PointState>& points, bool plane) {
    const auto contradiction = [&](const std::string& what) {
      fail(one, Failure::Kind::contradiction, fmt::format("element {}: {}", id, what));
      return false;
    };
    const bool plastic = material.kind == MaterialKind::plastic || material.kind == MaterialKind::anisotropic;
    double stress = 0, strain = 0;
    for (const PointState& point : points) {
      stress = std::max(stress, largest(point.stress));
      strain = std::max(strain, std::abs(point.plastic_strain));
      if (!std::isfinite(trace(point.stress) + point.stress[xy] + point.stress[yz] + point.stress[zx]) ||
          !(point.plastic_strain >= 0) || !(point.plastic_strain <= most_strain))
        return contradiction(fmt::format("the plastic strain {:g} or a stress beside it is out of range; use 0 to {:g}",
                                         point.plastic_strain, most_strain));
    }
    if (material.kind == MaterialKind::rubber || material.viscoelastic || material.crushable) {
      fail(one, Failure::Kind::not_calculated,
           fmt::format(
               "element {}: the stress of rubber or foam follows from its deformation since the start; remove the card",
               id));
      return false;
    }
    if (material.kind == MaterialKind::hydro) {
      fail(one, Failure::Kind::not_calculated,
           fmt::format("element {}: its pressure follows from an equation of state; remove the card", id));
      return false;
    }
    if (material.johnson_cook && strain > 0) {
      fail(one, Failure::Kind::not_calculated,
           fmt::format("element {}: the heat and damage that came with its plastic strain are not read; remove EPS",
                       id));
      return false;
    }
    if (!material.has_stress() && stress > 0) return contradiction("its material has no stress; remove the card");
    if (!plastic && strain > 0) return contradiction("its material does not flow, but EPS is not zero; set it to zero");
    if (stress > material.young && material.has_stress())
      return contradiction(
          fmt::format("the stress {:g} is beyond Young's modulus {:g}; look at its unit", stress, material.young));
    if (material.kinematic_slope > 0 && (strain > 0 || one.history_used)) {
      fail(one, Failure::Kind::not_calculated,
           fmt::format("element {}: the centre of the yield surface of kinematic hardening (BETA below 1) is not read; "
                       "remove EPS and the history variables, or set BETA to 1",
                       id));
      return false;
    }
    if (material.failure_strain > 0 && strain >= material.failure_strain)
      return contradiction(fmt::format("the plastic strain {:g} is not below {:g}, where it fails; delete the element",
                                       strain, material.failure_strain));
    if (one.history_used) history_.add(one, id);
    if (plastic && flows(material, points, plane)) outside_.add(one, id);
    return true;
  }

  /// A step without strain would change the stresses.
  static bool flows(const Material& material, const std::vector<PointState>& points, bool plane) {
    return std::any_of(points.begin(), points.end(), [&](PointState point) {
      const double before = largest(point.stress);
      const Symmetric start = point.stress;
      if (plane)
        update_plane_stress(material, {}, 1, point);
      else
        update_stress(material, {}, 1, point);
      Symmetric change;
      for (std::size_t k = 0; k < change.size(); ++k) change[k] = point.stress[k] - start[k];
      return largest(change) > 1e-3 * before;
    });
  }

  [[nodiscard]] const std::vector<Vector>& x() const { return builder_.structure.state.x; }

  static constexpr double most_strain = 100;
  ConditionBuilder& builder_;
  std::vector<std::uint32_t> shells_, solids_;
  std::vector<bool> given_shells_, given_solids_;
  Tally history_, across_, outside_;
};

}  // namespace

void apply_initial_stresses(ConditionBuilder& builder) {
  if (!builder.model.initial_stresses.empty()) InitialStresses(builder).apply();
}

}  // namespace gapcheck::solver
