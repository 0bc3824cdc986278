#include "plain_kernel.hpp"

namespace gapcheck::bench {

void plain_eight(geometry::PairArrays& pairs, bool triangles);
void plain_eight(geometry::PairArrays& pairs, bool triangles) { plain_all<8>(pairs, triangles); }

}  // namespace gapcheck::bench
