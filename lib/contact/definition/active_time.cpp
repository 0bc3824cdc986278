#include "contact/definition/active_time.hpp"

#include <algorithm>
#include <cmath>

namespace gapcheck::contact {

ActiveTime active_time(const model::Contact& contact) {
  ActiveTime time;
  time.by_curve = contact.death == model::curve_of_times;
  if (time.by_curve) return time;
  time.start = contact.death < 0 ? std::abs(contact.birth) : std::max(0.0, contact.birth);
  time.end = std::abs(contact.death);
  return time;
}

}  // namespace gapcheck::contact
