#pragma once
#include <cstdint>
#include <gapcheck/start.hpp>
#include <optional>
#include <vector>

#include "base/vector.hpp"
#include "model/model.hpp"
#include "records/report.hpp"
#include "solver/start/start.hpp"

namespace gapcheck::api {

/// What StartMoves points into.
struct StartMoveColumns {
  explicit StartMoveColumns(const std::vector<StartMove>& moves);
  [[nodiscard]] StartMoves view() const;

  std::vector<std::uint32_t> contact;
  std::vector<std::int64_t> node, part, other_part;
  std::vector<double> from, to;
  std::vector<StartCause> cause;
};

/// What StartNodes points into.
struct StartNodeColumns {
  explicit StartNodeColumns(const std::vector<StartNode>& nodes);
  [[nodiscard]] StartNodes view() const;

  std::vector<std::uint32_t> contact;
  std::vector<std::int64_t> node, part, other_part;
  std::vector<Outcome> outcome;
  std::vector<double> depth, contact_distance, energy, to_release;
};

struct StartStore {
  /// `nodes`: of the deck.
  StartStore(solver::Start from, const model::Nodes& nodes);
  [[nodiscard]] StartPositions positions() const;

  StartReport report;
  StartMoveColumns moves;
  StartNodeColumns nodes;
  std::vector<std::int64_t> ids;
  std::vector<Vector> deck, start;
  bool picture = false, mesh = false;  ///< in `audited`
  gapcheck::Report audited;            ///< with the moves; empty without either
};

}  // namespace gapcheck::api
