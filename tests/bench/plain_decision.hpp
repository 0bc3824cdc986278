#pragma once
#include <cstdint>

#include "decision_pairs.hpp"
#include "geometry/batch/pair_arrays.hpp"
#include "geometry/batch/pair_batch.hpp"

namespace gapcheck::bench {

/// What the certified decisions are measured against: the closest point in doubles and a comparison, without any proof.
/// Newton's method runs until it has settled, for that is what the answer hangs on here.
[[nodiscard]] bool plain_closer(const DecisionPair& pair);

/// The same for many pairs at once; sets `closer` and `apart` of the arrays.
void plain_batch(geometry::PairArrays& pairs, bool triangles, geometry::BatchWidth width);

}  // namespace gapcheck::bench
