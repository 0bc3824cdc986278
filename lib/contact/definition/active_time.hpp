#pragma once
#include "model/contact/contact.hpp"

namespace gapcheck::contact {

/// When a contact acts, in the transient phase. It never does if end <= start.
struct ActiveTime {
  double start = 0, end = 1e20;
  bool by_curve = false;  ///< DT = -9999: a curve says when; start and end are meaningless
};

/// What BT and DT mean. A negative BT applies only during dynamic relaxation, and the contact acts from the start of
/// the transient phase, unless DT is negative too: then both apply, but only in the transient phase. Source: LS-DYNA
/// Keyword User's Manual, Vol. I, *CONTACT, card 2.
[[nodiscard]] ActiveTime active_time(const model::Contact& contact);

}  // namespace gapcheck::contact
