#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "model/entity/part.hpp"

namespace gapcheck::model {

/// *EOS_…: the pressure of solids by relative volume and energy (keyword manual, volume II), in the model's units.
struct EquationOfState {
  enum class Kind : std::uint8_t {
    linear_polynomial,  ///< 001
    gruneisen,          ///< 004
    tabulated,          ///< 009
    other,              ///< its cards were not read
  } kind = Kind::other;
  std::int64_t id = 0;
  std::string keyword;                 ///< as written
  std::array<double, 7> polynomial{};  ///< C0 … C6
  double c = 0, s1 = 0, s2 = 0, s3 = 0, gamma = 0, a = 0;
  std::vector<std::array<double, 3>> rows;  ///< of the table: ln V, C, T; without blanks at its end
  bool by_curves = false;                   ///< LCC or LCT is given
  double e0 = 0, v0 = 0;                    ///< initial energy per reference volume; relative volume, as written
  Place place;
};

/// The bulk modulus at V = 1 and E0, along an isentrope: ∂p/∂μ + p ∂p/∂E, μ = 1/V − 1. 0 where the law has none.
[[nodiscard]] double initial_bulk_modulus(const EquationOfState& state, double density);

}  // namespace gapcheck::model
