#include "api/start_store.hpp"

#include <utility>

namespace gapcheck::api {
namespace {

void append_point(const Vector& point, std::vector<double>& to) { to.insert(to.end(), point.begin(), point.end()); }

std::span<const double> rows_of(const std::vector<Vector>& points) {
  static_assert(sizeof(Vector) == 3 * sizeof(double));  // points lie one behind the other
  return points.empty() ? std::span<const double>() : std::span(points.front().data(), 3 * points.size());
}

static_assert(static_cast<int>(StartCause::shot) == static_cast<int>(gapcheck::StartCause::shot) &&
              static_cast<int>(StartCause::tied) == static_cast<int>(gapcheck::StartCause::tied) &&
              static_cast<int>(StartCause::first_cycle) == static_cast<int>(gapcheck::StartCause::first_cycle));

}  // namespace

StartMoveColumns::StartMoveColumns(const std::vector<StartMove>& moves) {
  for (const StartMove& move : moves) {
    contact.push_back(move.contact);
    node.push_back(move.node);
    part.push_back(move.part);
    other_part.push_back(move.other_part);
    append_point(move.from, from);
    append_point(move.to, to);
    cause.push_back(static_cast<StartCause>(move.cause));
  }
}

StartMoves StartMoveColumns::view() const { return {contact, node, part, other_part, from, to, cause}; }

StartNodeColumns::StartNodeColumns(const std::vector<StartNode>& nodes) {
  for (const StartNode& each : nodes) {
    contact.push_back(each.contact);
    node.push_back(each.node);
    part.push_back(each.part);
    other_part.push_back(each.other_part);
    outcome.push_back(static_cast<Outcome>(each.outcome));  // the two lists are the same; see columns.cpp
    depth.push_back(each.depth);
    contact_distance.push_back(each.contact_distance);
    energy.push_back(each.energy);
    to_release.push_back(each.to_release);
  }
}

StartNodes StartNodeColumns::view() const {
  return {contact, node, part, other_part, outcome, depth, contact_distance, energy, to_release};
}

StartStore::StartStore(solver::Start from, const model::Nodes& all)
    : report(std::move(from.report)),
      moves(report.moves),
      nodes(report.nodes),
      ids(all.id.begin(), all.id.end()),
      deck(all.x.begin(), all.x.end()),
      start(std::move(from.x)) {}

StartPositions StartStore::positions() const { return {ids, rows_of(deck), rows_of(start)}; }

}  // namespace gapcheck::api
