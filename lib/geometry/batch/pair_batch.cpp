#include "geometry/batch/pair_batch.hpp"

#include "geometry/batch/pair_kernel.hpp"
#include "geometry/batch/pair_widths.hpp"

namespace gapcheck::geometry {
namespace {

BatchWidth widest() {
  static const BatchWidth width = batch_widths().back();
  return width;
}

}  // namespace

std::vector<BatchWidth> batch_widths() {
  std::vector<BatchWidth> widths{BatchWidth::two};
#if defined(GAPCHECK_WIDE_BATCHES)
  if (__builtin_cpu_supports("avx2")) widths.push_back(BatchWidth::four);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")) widths.push_back(BatchWidth::eight);
#endif
  return widths;
}

void PairBatch::decide() { decide(widest()); }

void PairBatch::decide([[maybe_unused]] BatchWidth width) {
#if defined(GAPCHECK_WIDE_BATCHES)
  if (width == BatchWidth::eight) return decide_eight(arrays_, triangles_);
  if (width == BatchWidth::four) return decide_four(arrays_, triangles_);
#endif
  decide_all<2>(arrays_, triangles_);
}

}  // namespace gapcheck::geometry
