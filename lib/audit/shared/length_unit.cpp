#include "audit/shared/length_unit.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "audit/rule.hpp"

namespace gapcheck::audit {
namespace {

constexpr double inch = 0.0254, foot = 0.3048, pound_force = 4.4482216152605;

constexpr std::array systems{
    UnitSystem{"mm-ms-kg", 1e-3, 1e-3, 1},
    UnitSystem{"mm-s-t", 1e-3, 1, 1e3},
    UnitSystem{"mm-ms-g", 1e-3, 1e-3, 1e-3},
    UnitSystem{"mm-s-kg", 1e-3, 1, 1},
    UnitSystem{"cm-us-g", 1e-2, 1e-6, 1e-3},
    UnitSystem{"cm-s-g", 1e-2, 1, 1e-3},
    UnitSystem{"m-s-kg", 1, 1, 1},
    UnitSystem{"in-s-lbf", inch, 1, pound_force / inch},
    UnitSystem{"ft-s-lbf", foot, 1, pound_force / foot},
};

/// Ranges of density in kg/m3 and Young's modulus in Pa, wide enough for all alloys in use. The systems of units differ
/// by far more in at least one of the two, so that no two fit.
struct Metal {
  std::string_view name;
  double lightest, heaviest, softest, stiffest;
};
constexpr std::array metals{
    Metal{"steel", 7600, 8100, 185e9, 220e9},
    Metal{"aluminium", 2600, 2850, 65e9, 76e9},
};

/// Two lengths in metres are the same unit: some write 0.305 for a foot.
bool same_length(double a, double b) { return std::abs(a - b) <= 0.01 * b; }

std::string unit_name(double metre) {
  constexpr std::array<std::pair<double, std::string_view>, 5> names{
      {{1e-3, "mm"}, {1e-2, "cm"}, {1, "m"}, {inch, "in"}, {foot, "ft"}}};
  for (const auto& [length, name] : names)
    if (same_length(metre, length)) return std::string(name);
  return fmt::format("{:g} m", metre);
}

}  // namespace

std::span<const UnitSystem> unit_systems() { return systems; }

std::optional<KnownMetal> known_metal(const model::Material& material) {
  for (const UnitSystem& units : systems) {
    const double cube = units.metre * units.metre * units.metre;
    const double density = material.density * units.kilogram / cube;
    const double young = material.young * units.kilogram / (units.metre * units.second * units.second);
    for (const Metal& metal : metals)
      if (density >= metal.lightest && density <= metal.heaviest && young >= metal.softest && young <= metal.stiffest)
        return KnownMetal{metal.name, &units};
  }
  return std::nullopt;
}

LengthUnit inferred_length_unit(const model::Model& model) {
  double metre = model.controls.length_unit;
  std::string reason = metre > 0 ? "as *CONTROL_UNITS says" : "";
  for (const model::Part& part : model.parts) {
    if (!part.material) continue;
    const model::Material& material = model.materials[*part.material];
    const auto metal = known_metal(material);
    if (!metal) continue;
    if (metre > 0 && !same_length(metre, metal->units->metre)) return {};
    if (metre > 0) continue;
    metre = metal->units->metre;
    reason = fmt::format("because material {} looks like {}", material.id, metal->metal);
  }
  if (!(metre > 0)) return {};
  return {1e-3 / metre, fmt::format("taking the unit of length for {}, {}", unit_name(metre), reason)};
}

LengthUnit length_unit(const Context& context) {
  if (context.options().millimetre > 0) return {context.options().millimetre, {}};
  return inferred_length_unit(context.model());
}

}  // namespace gapcheck::audit
