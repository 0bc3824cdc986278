#pragma once
#include <vector>

#include "report/compare/curves.hpp"

namespace gapcheck::report {

/// The curves of sections, supports, loads and motions, walls, rigid bodies, welds, elements, springs, joints and
/// contact surfaces, each named after its entity: "secforc section 3 x-force".
void add_history_curves(const results::RunResults& run, std::vector<Curve>& list);

}  // namespace gapcheck::report
