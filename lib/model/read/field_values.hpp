#pragma once
#include <cstddef>
#include <cstdint>

#include "base/vector.hpp"
#include "keyword/card.hpp"

namespace gapcheck::model {

// How readers of many keywords take the values of a card's fields.

/// The solver takes zero and blank for its default.
[[nodiscard]] inline double or_default(double value, double default_value) {
  return value == 0 ? default_value : value;
}
[[nodiscard]] inline std::int64_t or_default(std::int64_t value, std::int64_t default_value) {
  return value == 0 ? default_value : value;
}

/// A vector in three fields that stand one behind the other.
[[nodiscard]] inline Vector vector_at(const keyword::Card& card, std::size_t field) {
  return {card.real(field), card.real(field + 1), card.real(field + 2)};
}

}  // namespace gapcheck::model
