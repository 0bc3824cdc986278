#pragma once
#include <string>

namespace gapcheck::bench {

/// A deck of two stacked plates with n x n shells each: elements of 5, 1 thick, mid-surfaces 0.7 apart, the upper plate
/// shifted by 0.3 and 0.4 of an element, all in one *CONTACT_AUTOMATIC_SINGLE_SURFACE; every node over the other plate
/// penetrates by 0.3: 2 n² of them. Standard format; about 212 n² bytes. `stray` adds one shell 150000 away.
[[nodiscard]] std::string plates_deck(int n, bool stray);

}  // namespace gapcheck::bench
