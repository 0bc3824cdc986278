#include "geometry/batch/pair_kernel.hpp"
#include "geometry/batch/pair_widths.hpp"

namespace gapcheck::geometry {

void decide_four(PairArrays& pairs, bool triangles) { decide_all<4>(pairs, triangles); }

}  // namespace gapcheck::geometry
