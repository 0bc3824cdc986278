#include "geometry/batch/pair_kernel.hpp"
#include "geometry/batch/pair_widths.hpp"

namespace gapcheck::geometry {

void decide_eight(PairArrays& pairs, bool triangles) { decide_all<8>(pairs, triangles); }

}  // namespace gapcheck::geometry
