#pragma once
#include "geometry/batch/pair_arrays.hpp"

namespace gapcheck::geometry {

/// The kernel of PairBatch for processors with AVX2 (four doubles) and AVX-512 F and DQ (eight).
void decide_four(PairArrays& pairs, bool triangles);
void decide_eight(PairArrays& pairs, bool triangles);

}  // namespace gapcheck::geometry
