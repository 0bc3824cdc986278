#include "records/baseline.hpp"

#include <algorithm>

namespace gapcheck {

std::string_view name(BaselineState state) {
  switch (state) {
    case BaselineState::fresh:
      return "new";
    case BaselineState::worse:
      return "worse";
    case BaselineState::unchanged:
      return "unchanged";
  }
  return "?";
}

std::size_t BaselineComparison::count(BaselineState state) const {
  return static_cast<std::size_t>(std::count(states.begin(), states.end(), state));
}

}  // namespace gapcheck
