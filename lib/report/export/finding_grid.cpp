#include "report/export/finding_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

#include "base/ids.hpp"
#include "base/number.hpp"
#include "report/export/exports_groups.hpp"
#include "report/item/describe.hpp"
#include "report/item/describe_tie.hpp"

namespace gapcheck::report {
namespace {

constexpr int first_outcome = 1, first_tie_reason = 11;

/// 101 for "GC101"; 0 for anything that is not a rule id.
std::int64_t rule_number(std::string_view id) { return id.size() > 2 ? parse_integer(id.substr(2)).value_or(0) : 0; }

std::int64_t contact_id(const Report& report, std::uint32_t position) {
  return position < report.contacts.size() ? report.contacts[position].id : 0;
}

std::vector<std::string> outcome_words() {
  std::vector<std::string> words{"0 none"};
  for (const Outcome outcome : {Outcome::moved, Outcome::kept, Outcome::forced, Outcome::released, Outcome::reported})
    words.push_back(fmt::format("{} {}", first_outcome + static_cast<int>(outcome), name(outcome)));
  for (const TieReason reason : tie_reasons)
    words.push_back(fmt::format("{} {}", first_tie_reason + static_cast<int>(reason), name(reason)));
  return words;
}

/// Arrays parallel to the points.
struct PointArrays {
  std::vector<double> depth, remaining, way_out;
  std::vector<std::int64_t> node, contact, outcome, rule;

  void add(std::int64_t id) {
    depth.push_back(0);
    remaining.push_back(std::numeric_limits<double>::quiet_NaN());
    way_out.insert(way_out.end(), 3, 0.0);
    node.push_back(id);
    for (auto* list : {&contact, &outcome, &rule}) list->push_back(0);
  }
};

/// Arrays parallel to the cells.
struct CellArrays {
  std::vector<double> thickness, depth;
  std::vector<std::int64_t> element, part, contact, rule;

  void add(std::int64_t element_id, std::int64_t part_id, std::int64_t contact_id, double contact_thickness) {
    thickness.push_back(contact_thickness);
    depth.push_back(0);
    element.push_back(element_id);
    part.push_back(part_id);
    contact.push_back(contact_id);
    rule.push_back(0);
  }
};

class FindingGrid {
 public:
  FindingGrid(const Report& report, const NodePosition& position) : report_(report), given_(position) {
    find_named();
    add_mesh();
    for (const Penetration& record : report.penetrations) add(record);
    for (const TieFailure& failure : report.tie_failures) add(failure);
    for (const Finding& finding : report.findings) add(finding);
  }

  VtuGrid grid() && {
    grid_.point_data = {{"depth", 1, std::move(points_.depth)},
                        {.name = "remaining", .values = std::move(points_.remaining), .gaps = true},
                        {"way_out", 3, std::move(points_.way_out)}};
    if (!report_.moves.empty()) grid_.point_data.push_back({"move", 3, moves()});
    grid_.point_ids = {{"node", std::move(points_.node)},
                       {"contact", std::move(points_.contact)},
                       {"outcome", std::move(points_.outcome)},
                       {"rule", std::move(points_.rule)}};
    grid_.cell_data = {{"thickness", 1, std::move(cells_.thickness)}, {"depth", 1, std::move(cells_.depth)}};
    grid_.cell_ids = {{"element", std::move(cells_.element)},
                      {"part", std::move(cells_.part)},
                      {"contact", std::move(cells_.contact)},
                      {"rule", std::move(cells_.rule)}};
    grid_.words = {{"input", {printable(report_.input)}}, {"outcomes", outcome_words()}, {"left_out", left_out()}};
    return std::move(grid_);
  }

 private:
  /// From each point to where its node goes.
  [[nodiscard]] std::vector<double> moves() const {
    std::vector<double> list(3 * grid_.points.size(), 0.0);
    for (std::size_t p = 0; p < grid_.points.size(); ++p) {
      const auto move = std::lower_bound(report_.moves.begin(), report_.moves.end(), points_.node[p],
                                         [](const NodeMove& m, std::int64_t node) { return m.node < node; });
      if (move == report_.moves.end() || move->node != points_.node[p] || !move->to.allFinite()) continue;
      for (std::size_t k = 0; k < 3; ++k) list[3 * p + k] = move->to[static_cast<int>(k)] - grid_.points[p][k];
    }
    return list;
  }

  /// Only nodes and elements that findings name are looked up later.
  void find_named() {
    for (const Penetration& record : report_.penetrations) {
      point_of_.emplace(record.node, no_position);
      for (const std::int64_t node : record.segment) point_of_.emplace(node, no_position);
      if (record.element != 0) cells_of_[record.element];
    }
    for (const TieFailure& failure : report_.tie_failures) point_of_.emplace(failure.node, no_position);
    for (const Finding& finding : report_.findings) {
      if (finding.node != 0) point_of_.emplace(finding.node, no_position);
      if (finding.element != 0) cells_of_[finding.element];
    }
  }

  void add_mesh() {
    if (!report_.mesh) return;
    const ElementMesh& mesh = *report_.mesh;
    for (std::size_t i = 0; i < mesh.x.size(); ++i) add_point(mesh.node_ids[i], mesh.x[i]);
    for (std::size_t i = 0; i < mesh.size(); ++i) {
      if (const auto named = cells_of_.find(mesh.element_ids[i]); named != cells_of_.end())
        named->second.push_back(static_cast<std::uint32_t>(i));
      grid_.add_cell(mesh.corners_of(i));
      cells_.add(mesh.element_ids[i], mesh.part_ids[i], mesh.contact_ids[i], mesh.thickness[i]);
    }
  }

  /// Of two nodes with one id the first is looked up.
  void add_point(std::int64_t id, const Vector& x) {
    if (const auto named = point_of_.find(id); named != point_of_.end() && named->second == no_position)
      named->second = static_cast<std::uint32_t>(grid_.points.size());
    grid_.points.push_back({x[0], x[1], x[2]});
    points_.add(id);
  }

  [[nodiscard]] std::optional<Vector> position(std::int64_t node) const {
    if (const auto named = point_of_.find(node); named != point_of_.end() && named->second != no_position) {
      const auto& x = grid_.points[named->second];
      return Vector(x[0], x[1], x[2]);
    }
    return given_ ? given_(node) : std::nullopt;
  }

  /// The point of a node, which becomes a vertex where no element has it; no_position if its position is not known.
  std::uint32_t point(std::int64_t node, std::int64_t part, const std::optional<Vector>& x) {
    const auto known = point_of_.find(node)->second;
    if (known != no_position) return known;
    if (!x || !x->allFinite()) {
      ++nodes_left_out_;
      return no_position;
    }
    const auto added = static_cast<std::uint32_t>(grid_.points.size());
    add_point(node, *x);
    grid_.add_cell(std::array<std::uint32_t, 1>{added});
    cells_.add(0, part, 0, 0);
    return added;
  }

  void add(const Penetration& record) {
    const NodePosition known = [this](std::int64_t node) { return position(node); };
    const std::int64_t rule = rule_number(rule_of(record.kind).id), contact = contact_id(report_, record.contact);
    const double depth = record.depth > 0 && std::isfinite(record.depth) ? record.depth : 0;
    for_cells(record.element, [&](std::uint32_t cell) {
      if (record.element_part != 0 && cells_.part[cell] != record.element_part) return;
      mark(cells_.rule[cell], rule);
      cells_.depth[cell] = std::max(cells_.depth[cell], depth);
    });
    const std::uint32_t p = point(record.node, record.part, node_of(report_, record, known));
    if (p == no_position) return;
    const bool first = points_.rule[p] == 0;
    mark(points_.rule[p], rule);
    if (!first && !(depth > points_.depth[p])) return;
    points_.depth[p] = depth;
    // Solids have no thickness; in solver files the distance is missing.
    const bool distance_known = report_.source == "deck" || record.contact_distance > 0;
    points_.remaining[p] = distance_known ? record.remaining() : std::numeric_limits<double>::quiet_NaN();
    points_.contact[p] = contact;
    points_.outcome[p] = first_outcome + static_cast<int>(record.outcome);
    const auto line = penetration_line(report_, record, known);
    const Vector way = line ? Vector(line->surface - line->node) : Vector(Vector::Zero());
    for (std::size_t k = 0; k < 3; ++k) points_.way_out[3 * std::size_t{p} + k] = way[static_cast<int>(k)];
  }

  void add(const TieFailure& failure) {
    const std::uint32_t p =
        point(failure.node, failure.part, failure.position ? failure.position : position(failure.node));
    if (p == no_position || points_.rule[p] != 0) return;
    points_.rule[p] = rule_number(rule_of(failure).id);
    points_.contact[p] = contact_id(report_, failure.contact);
    points_.outcome[p] = first_tie_reason + static_cast<int>(failure.reason);
  }

  void add(const Finding& finding) {
    const std::int64_t rule = rule_number(finding.id);
    for_cells(finding.element, [&](std::uint32_t cell) {
      const std::int64_t part = cells_.part[cell];
      const bool any_part = finding.part == 0 && finding.element_part == 0;
      if (any_part || part == finding.part || part == finding.element_part) mark(cells_.rule[cell], rule);
    });
    if (finding.node == 0) return;
    const auto x = position(finding.node);
    const std::uint32_t p = point(finding.node, finding.part, x ? x : finding.point);
    if (p == no_position || points_.rule[p] != 0) return;
    points_.rule[p] = rule;
    points_.contact[p] = finding.contact;
  }

  template <class Visit>
  void for_cells(std::int64_t element, const Visit& visit) const {
    if (const auto named = cells_of_.find(element); named != cells_of_.end())
      for (const std::uint32_t cell : named->second) visit(cell);
  }
  static void mark(std::int64_t& value, std::int64_t rule) {
    if (value == 0) value = rule;
  }

  [[nodiscard]] std::vector<std::string> left_out() const {
    std::vector<std::string> words;
    if (report_.mesh && report_.mesh->left_out > 0)
      words.push_back(fmt::format("{} elements: a node has no finite coordinates", report_.mesh->left_out));
    if (nodes_left_out_ > 0)
      words.push_back(fmt::format("{} findings at nodes: their position is not known", nodes_left_out_));
    return words;
  }

  const Report& report_;
  const NodePosition& given_;
  VtuGrid grid_;
  PointArrays points_;
  CellArrays cells_;
  std::unordered_map<std::int64_t, std::uint32_t> point_of_;               ///< of nodes that findings name
  std::unordered_map<std::int64_t, std::vector<std::uint32_t>> cells_of_;  ///< of elements that findings name
  std::uint64_t nodes_left_out_ = 0;
};

}  // namespace

VtuGrid finding_grid(const Report& report, const NodePosition& position) {
  return FindingGrid(report, position).grid();
}

}  // namespace gapcheck::report
