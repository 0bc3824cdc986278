#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace gapcheck::model {

// Foams and rubbers, in the model's units; the numbers of curves stay in those of their file. Zero = not given.

/// Material 057.
struct LowDensityFoam {
  std::int64_t curve = 0;                                   ///< LCID
  double cutoff = 0;                                        ///< TC
  double unloading = 0, shape = 0, decay = 0, damping = 0;  ///< HU, SHAPE, BETA, DAMP
  double fail = 0, bulk_viscosity = 0;                      ///< FAIL, BVFLAG
  double relaxing = 0, relaxation_rate = 0;                 ///< ED, BETA1
  double contact = 0, reference = 0;                        ///< KCON, REF
};

/// Material 063.
struct CrushableFoam {
  std::int64_t curve = 0;
  double cutoff = 0, damping = 0, model = 0;  ///< TSC, DAMP, MODEL
};

/// Material 006.
struct Viscoelastic {
  double bulk = 0, shear = 0, long_shear = 0, decay = 0;  ///< BULK, G0, GI, BETA
};

/// Material 007.
struct BlatzKo {
  double shear = 0, reference = 0;
};

/// A test of a specimen: force over elongation, or stress over strain with lengths of 1.
struct SpecimenTest {
  double length = 0, width = 0, thickness = 0;  ///< SGL, SW, ST
  std::int64_t curve = 0;
};

/// Material 181.
struct TabulatedRubber {
  SpecimenTest test;
  double bulk = 0, damping = 0, poisson = 0;  ///< KM, MU, PR
  double unloading = 0, shape = 0;            ///< HU, SHAPE
  double tension = 0, rate_type = 0;          ///< TENSION, RTYPE, of tables
  double averaging = 0;                       ///< AVGOPT of tables; below 0: minus a time
  std::int64_t unloading_curve = 0;
  std::string unread;  ///< the first field or option that is not calculated
};

/// Materials 077_O and 077_H with given constants.
struct ConstantRubber {
  bool ogden = false;
  std::array<double, 8> mu{}, alpha{};  ///< 077_O
  std::array<double, 6> c{};            ///< 077_H: C10, C01, C11, C20, C02, C30
  std::string unread;
};

using FoamRubber =
    std::variant<std::monostate, LowDensityFoam, CrushableFoam, Viscoelastic, BlatzKo, TabulatedRubber, ConstantRubber>;

/// The steepest piece of a curve; 0 where it has no two points with rising abscissas.
[[nodiscard]] double largest_slope(const std::vector<std::array<double, 2>>& points);
/// The slope of its last piece, likewise.
[[nodiscard]] double last_slope(const std::vector<std::array<double, 2>>& points);

}  // namespace gapcheck::model
