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

ActiveTime active_time_in_relaxation(const model::Contact& contact) {
  ActiveTime time = active_time(contact);
  if (time.by_curve) return time;
  if (contact.death < 0) return {0, 0};
  time.start = std::abs(contact.birth);
  return time;
}

const model::Curve* times_curve(const model::Model& model, const model::Contact& contact) {
  if (!active_time(contact).by_curve || !(std::abs(contact.birth) < 1e15)) return nullptr;
  const auto found = model.curves.find(static_cast<std::int64_t>(contact.birth));
  return found == model.curves.end() ? nullptr : &found->second;
}

ActiveTimes::ActiveTimes(const model::Model& model, const model::Contact& contact) {
  const ActiveTime time = active_time(contact);
  if (!time.by_curve) {
    windows_.push_back({time.start, time.end});
    const ActiveTime before = active_time_in_relaxation(contact);
    relaxation_.push_back({before.start, before.end});
    return;
  }
  const model::Curve* const curve = times_curve(model, contact);
  if (curve == nullptr) return;
  for (const auto& [birth, death] : curve->points)
    windows_.push_back({birth * curve->abscissa_time, death * curve->abscissa_time});
  relaxation_ = windows_;
}

bool ActiveTimes::at(double time, bool relaxing) const {
  const auto& windows = relaxing ? relaxation_ : windows_;
  return std::any_of(windows.begin(), windows.end(),
                     [&](const auto& window) { return time >= window[0] && time < window[1]; });
}

}  // namespace gapcheck::contact
