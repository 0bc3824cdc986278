#pragma once
#include <cstddef>
#include <cstdint>

#include "base/vector.hpp"
#include "keyword/card.hpp"

namespace gapcheck::model {

// How the readers of many keywords interpret the values of a card's fields.

/// The solver treats zero and blank as its default.
[[nodiscard]] inline double or_default(double value, double default_value) {
  return value == 0 ? default_value : value;
}
[[nodiscard]] inline std::int64_t or_default(std::int64_t value, std::int64_t default_value) {
  return value == 0 ? default_value : value;
}

/// A vector in three consecutive fields.
[[nodiscard]] inline Vector vector_at(const keyword::Card& card, std::size_t field) {
  return {card.real(field), card.real(field + 1), card.real(field + 2)};
}

}  // namespace gapcheck::model
