#pragma once
#include <memory>
#include <variant>

#include "base/diagnostic.hpp"
#include "model/model.hpp"
#include "solver/state/failure.hpp"
#include "solver/condition/springs.hpp"
#include "solver/structure/structure.hpp"

namespace gapcheck::solver {

/// The discrete elements of a deck with the materials S01, S02 and S04, once all masses are there. A missing part,
/// section, material or curve and any other material is a failure; what a section or material asks for beyond them, and
/// elements with an orientation vector, are named in `diagnostics` and not calculated. Null where there are none.
[[nodiscard]] std::variant<std::unique_ptr<Springs>, Failure> build_springs(const model::Model& model,
                                                                            const Structure& structure,
                                                                            Diagnostics& diagnostics);

}  // namespace gapcheck::solver
