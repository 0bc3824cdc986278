#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "model/model.hpp"

namespace gapcheck::audit {

class Context;

/// Thinner shells should be thickened for contact, and with this SST a deck should be free of penetrations, in
/// millimetres. Source: contact rules, section 11.
inline constexpr double recommended_millimetres = 0.5;

/// A system of units in use.
struct UnitSystem {
  std::string_view name;           ///< length-time-mass; pounds: force
  double metre, second, kilogram;  ///< its units in these; kilogram: of the unit of mass
};
/// All that gapcheck knows.
[[nodiscard]] std::span<const UnitSystem> unit_systems();

/// A metal that a material's constants fit.
struct KnownMetal {
  std::string_view metal;  ///< "steel", "aluminium"
  const UnitSystem* units = nullptr;
};
/// The metal and the system of units whose density and Young's modulus a material has; none: of no known one.
[[nodiscard]] std::optional<KnownMetal> known_metal(const model::Material& material);

/// A deck's unit of length.
struct LengthUnit {
  double millimetre = 0;   ///< a millimetre in it; 0: not known
  std::string assumption;  ///< "taking the unit of length for mm, because material 1 looks like steel"; empty: given
  [[nodiscard]] bool known() const { return millimetre > 0; }
  /// ", taking …", or nothing.
  [[nodiscard]] std::string clause() const { return assumption.empty() ? std::string() : ", " + assumption; }
};

/// Taken from *CONTROL_UNITS and from the materials of parts that look like steel or aluminium; not known if they
/// contradict each other.
[[nodiscard]] LengthUnit inferred_length_unit(const model::Model& model);
/// The unit that the user gives, else the inferred one.
[[nodiscard]] LengthUnit length_unit(const Context& context);

}  // namespace gapcheck::audit
