#pragma once
#include <cstdint>
#include <map>
#include <optional>

#include "base/diagnostic.hpp"
#include "model/model.hpp"
#include "solver/state/failure.hpp"
#include "solver/state/mass_scaling.hpp"
#include "solver/structure/structure.hpp"

namespace gapcheck::solver {

/// Adds discrete beams (ELFORM 6) of materials 066, 067, 068 and 071 to a structure.
class DiscreteBeams {
 public:
  DiscreteBeams(const model::Model& model, Diagnostics& diagnostics) : model_(model), diagnostics_(diagnostics) {}

  /// The part's beams are of that kind.
  [[nodiscard]] static bool has(const model::Model& model, PartIndex part);
  /// Adds a beam whose nodes exist. `third`: a point across it, from the first node; zero: none. A failure names what
  /// is missing or absurd.
  [[nodiscard]] SolverStatus add(std::uint32_t beam, const Vector& third, const MassScaling& scaling,
                                 Structure& structure);

 private:
  struct Built {
    std::uint32_t properties = 0;
    std::optional<Matrix> axes;
  };
  [[nodiscard]] SolverResult<Built> build(const model::Part& part, Structure& structure);
  const model::Model& model_;
  Diagnostics& diagnostics_;
  std::map<std::uint32_t, Built> built_;  ///< by part
};

}  // namespace gapcheck::solver
