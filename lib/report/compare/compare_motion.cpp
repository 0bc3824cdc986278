#include "report/compare/compare_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <system_error>
#include <unordered_map>
#include <utility>

#include "base/work_watch.hpp"
#include "results/d3plot/mesh_source.hpp"

namespace gapcheck::report {
namespace {

using results::D3plot;
using results::D3plotState;
using results::D3plotStates;
using Point = std::array<double, 3>;

/// With three arguments hypot may lose a NaN.
double distance(const Point& a, const Point& b) {
  return std::hypot(std::hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

/// The coordinates of a run at ascending times, linear between two states.
class Motion {
 public:
  explicit Motion(const D3plotStates& states) : states_(states) {}

  /// Finds the states around a time in the run's range; false: they lack coordinates.
  bool move_to(double time) {
    const auto& times = states_.times();
    std::size_t after = next_;
    while (after + 1 < times.size() && times[after] < time) ++after;
    if (after != next_ || later_.coordinates.empty()) {
      earlier_ = after == next_ + 1 && !later_.coordinates.empty() ? std::move(later_)
                                                                   : states_.read(after > 0 ? after - 1 : 0);
      later_ = states_.read(after);
      next_ = after;
    }
    const double before = earlier_.time, width = later_.time - before;
    share_ = width > 0 ? std::clamp((time - before) / width, 0.0, 1.0) : 1;
    const std::size_t nodes = states_.mesh().node_ids.size();
    return earlier_.coordinates.size() == nodes && later_.coordinates.size() == nodes;
  }

  [[nodiscard]] Point at(std::size_t node) const {
    if (share_ == 1) return later_.coordinates[node];
    Point point = earlier_.coordinates[node];
    for (std::size_t i = 0; i < 3; ++i) point[i] = point[i] * (1 - share_) + later_.coordinates[node][i] * share_;
    return point;
  }

 private:
  const D3plotStates& states_;
  D3plotState earlier_, later_;
  std::size_t next_ = 0;
  double share_ = 1;
};

/// A node of both runs: positions in their lists, and in the list of parts.
struct NodePair {
  std::size_t first = 0, second = 0, part = 0;
};

/// Matches the nodes, and lists their parts in ascending order.
std::vector<NodePair> match_nodes(const D3plot& first, const D3plot& second, MotionComparison& result) {
  const results::MeshSource mesh = results::mesh_source(first);
  std::unordered_map<std::int64_t, std::size_t> in_second;
  for (std::size_t i = 0; i < second.node_ids.size(); ++i) in_second.emplace(second.node_ids[i], i);
  std::map<std::int64_t, std::size_t> counts;
  std::vector<std::pair<NodePair, std::int64_t>> matched;
  for (std::size_t i = 0; i < first.node_ids.size(); ++i) {
    const auto other = in_second.find(first.node_ids[i]);
    if (other == in_second.end()) continue;
    const auto part = mesh.parts.find(first.node_ids[i]);
    const std::int64_t id = part == mesh.parts.end() ? 0 : part->second;
    ++counts[id];
    matched.push_back({{i, other->second, 0}, id});
  }
  result.only_first = first.node_ids.size() - matched.size();
  result.only_second = second.node_ids.size() - matched.size();
  std::map<std::int64_t, std::size_t> place;
  for (const auto& [id, nodes] : counts) {
    place.emplace(id, result.parts.size());
    result.parts.push_back({});
    result.parts.back().part = id;
    result.parts.back().nodes = nodes;
  }
  std::vector<NodePair> pairs;
  pairs.reserve(matched.size());
  for (auto& [pair, id] : matched) {
    pair.part = place.at(id);
    pairs.push_back(pair);
  }
  return pairs;
}

/// What rounding to the databases' precision can move a node by.
double rounding(const D3plot& first, const D3plot& second) {
  double largest = 0;
  for (const D3plot* mesh : {&first, &second})
    for (const Point& point : mesh->coordinates)
      for (const double value : point) largest = std::max(largest, std::abs(value));
  const bool single = first.word_bytes == 4 || second.word_bytes == 4;
  return 4 * largest *
         (single ? static_cast<double>(std::numeric_limits<float>::epsilon()) : std::numeric_limits<double>::epsilon());
}

/// Adds the distances at one time.
void add_state(const D3plotStates& first, const D3plotStates& second, const Motion& a, const Motion& b,
               const std::vector<NodePair>& pairs, double time, MotionComparison& result) {
  for (PartMotion& part : result.parts) {
    part.largest.push_back(0);
    part.mean.push_back(0);
  }
  for (const NodePair& pair : pairs) {
    PartMotion& part = result.parts[pair.part];
    const Point x = a.at(pair.first), y = b.at(pair.second);
    const double apart = distance(x, y);
    const double moved = std::max(distance(x, first.mesh().coordinates[pair.first]),
                                  distance(y, second.mesh().coordinates[pair.second]));
    if (!std::isfinite(apart) || !std::isfinite(moved)) {
      part.not_numbers = true;
      continue;
    }
    result.largest_displacement = std::max(result.largest_displacement, moved);
    part.mean.back() += apart / static_cast<double>(part.nodes);
    part.largest.back() = std::max(part.largest.back(), apart);
    if (apart > part.largest_distance) {
      part.largest_distance = apart;
      part.time = time;
      part.node = first.mesh().node_ids[pair.first];
    }
  }
}

}  // namespace

MotionComparison compare_motion(const D3plotStates& first, const D3plotStates& second, double tolerance) {
  MotionComparison result;
  result.tolerance = tolerance;
  if (first.size() == 0 || second.size() == 0) return result;
  result.end_first = first.times().back();
  result.end_second = second.times().back();
  const std::vector<NodePair> pairs = match_nodes(first.mesh(), second.mesh(), result);
  Motion a(first), b(second);
  double latest = -std::numeric_limits<double>::infinity();
  for (const double time : first.times()) {
    if (time < second.times().front() || time > result.end_second || time <= latest) continue;
    if (work_stopped() || !a.move_to(time) || !b.move_to(time)) break;
    latest = time;
    result.times.push_back(time);
    add_state(first, second, a, b, pairs, time, result);
  }
  const double allowed = std::max(tolerance * result.largest_displacement, rounding(first.mesh(), second.mesh()));
  for (PartMotion& part : result.parts) {
    part.differs = part.not_numbers || part.largest_distance > allowed;
    if (part.differs) ++result.differ;
  }
  std::stable_sort(result.parts.begin(), result.parts.end(), [](const PartMotion& p, const PartMotion& q) {
    return std::pair(!p.not_numbers, -p.largest_distance) < std::pair(!q.not_numbers, -q.largest_distance);
  });
  return result;
}

std::optional<MotionComparison> compare_motion(const std::string& first_directory, const std::string& second_directory,
                                               double tolerance, Diagnostics& diagnostics) {
  namespace fs = std::filesystem;
  const fs::path first = fs::path(first_directory) / "d3plot", second = fs::path(second_directory) / "d3plot";
  std::error_code failed;
  if (!fs::exists(first, failed) || !fs::exists(second, failed)) return std::nullopt;
  const auto a = D3plotStates::open(first.string()), b = D3plotStates::open(second.string());
  for (const auto* plot : {&a, &b}) {
    if (*plot) continue;
    Diagnostic fault = plot->error();
    fault.severity = Severity::warning;
    fault.message += "; the motion of nodes is not compared";
    diagnostics.add(std::move(fault));
  }
  if (!a || !b) return std::nullopt;
  return compare_motion(a.value(), b.value(), tolerance);
}

}  // namespace gapcheck::report
