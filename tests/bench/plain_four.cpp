#include "plain_kernel.hpp"

namespace gapcheck::bench {

void plain_four(geometry::PairArrays& pairs, bool triangles);
void plain_four(geometry::PairArrays& pairs, bool triangles) { plain_all<4>(pairs, triangles); }

}  // namespace gapcheck::bench
