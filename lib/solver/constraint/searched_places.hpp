#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "contact/search/search.hpp"
#include "solver/contact/search_margin.hpp"

namespace gapcheck::solver {

/// Positions of the nodes of all contacts at the last search. Its candidates are valid until any two nodes may have
/// come closer by the margin.
class SearchedPlaces {
 public:
  void set_margin(double margin) { margin_ = margin; }
  [[nodiscard]] double margin() const { return margin_; }
  /// Makes the next search due at once.
  void forget() { places_.clear(); }
  /// To be called at each search. `nodes`: positions in the model, the same in every call; `x`: coordinates by node.
  void set(const std::vector<std::uint32_t>& nodes, const std::vector<Vector>& x) {
    places_.clear();
    for (const std::uint32_t node : nodes) places_.push_back(x[node]);
  }
  /// Whether the candidates are still valid at the coordinates `x`.
  [[nodiscard]] bool valid(const std::vector<std::uint32_t>& nodes, const std::vector<Vector>& x) const {
    if (places_.empty()) return false;
    contact::Bounds ways;
    for (std::size_t i = 0; i < places_.size(); ++i) ways.add(x[nodes[i]] - places_[i]);
    const Vector drift = (ways.low + ways.high) / 2;  // common motion brings nothing closer
    double squared = 0;
    for (std::size_t i = 0; i < places_.size(); ++i)
      squared = std::max(squared, (x[nodes[i]] - places_[i] - drift).squaredNorm());
    return 2 * std::sqrt(squared) * rounding_of_motion <= margin_;
  }

 private:
  std::vector<Vector> places_;  // parallel to nodes; empty: no search yet
  double margin_ = 0;
};

}  // namespace gapcheck::solver
