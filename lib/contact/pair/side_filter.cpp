#include "contact/pair/side_filter.hpp"

#include <cmath>

namespace gapcheck::contact {

bool SideFilter::apart(const Vector& query, double bound) const {
  if (!band_.usable()) return false;
  const double height = front_ * band_.height(query);
  // The whole facet is farther.
  const double least = std::abs(height) - band_.warp() - band_.error(query, std::abs(bound));
  const bool not_closer = !(bound > 0) || least > bound;
  if (!not_closer) return false;
  if (height > 0 && least > 0) return true;
  return least > behind_ || band_.outside(query);
}

}  // namespace gapcheck::contact
