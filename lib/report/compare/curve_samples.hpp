#pragma once
#include <cstddef>
#include <vector>

#include "report/compare/curves.hpp"

namespace gapcheck::report {

/// Value of a curve at any time in its range, linear between its states; the times asked for must ascend. Beyond its
/// ends the curve keeps its first and last value.
class CurveSampler {
 public:
  /// The curve has at least one state and must outlive the sampler.
  explicit CurveSampler(const Curve& curve) : curve_(curve) {}

  double at(double time);

 private:
  const Curve& curve_;
  std::size_t next_ = 0;
};

/// `count` ≥ 2 values at equidistant times from begin to end, both included.
[[nodiscard]] std::vector<double> uniform_samples(const Curve& curve, double begin, double end, std::size_t count);

}  // namespace gapcheck::report
