#include "geometry/pair_kernel.hpp"
#include "geometry/pair_widths.hpp"

namespace gapcheck::geometry {

void decide_eight(PairArrays& pairs, bool triangles) { decide_all<8>(pairs, triangles); }

}  // namespace gapcheck::geometry
