#pragma once
#include <array>
#include <vector>

#include "model/model.hpp"

namespace gapcheck::contact {

/// When a contact acts, in the transient phase or in the dynamic relaxation before it. It never does if end <= start.
struct ActiveTime {
  double start = 0, end = 1e20;
  bool by_curve = false;  ///< DT = -9999: a curve says when; start and end are meaningless
};

/// What BT and DT mean. A negative BT applies only during dynamic relaxation, and the contact acts from the start of
/// the transient phase, unless DT is negative too: then both apply, but only in the transient phase. Source: LS-DYNA
/// Keyword User's Manual, Vol. I, *CONTACT, card 2.
[[nodiscard]] ActiveTime active_time(const model::Contact& contact);
/// The same in a dynamic relaxation: a negative BT is a birth there, and with a negative DT the contact does not act.
[[nodiscard]] ActiveTime active_time_in_relaxation(const model::Contact& contact);

/// All times at which a contact acts. With DT = -9999 each point of the curve BT is a birth and a death.
class ActiveTimes {
 public:
  explicit ActiveTimes(const ActiveTime& time) : windows_{{time.start, time.end}}, relaxation_(windows_) {}
  ActiveTimes(const model::Model& model, const model::Contact& contact);
  /// `relaxing`: at that time of the dynamic relaxation.
  [[nodiscard]] bool at(double time, bool relaxing = false) const;

 private:
  std::vector<std::array<double, 2>> windows_, relaxation_;
};

/// The curve of births and deaths; nullptr: none is named, or it is missing.
[[nodiscard]] const model::Curve* times_curve(const model::Model& model, const model::Contact& contact);

}  // namespace gapcheck::contact
