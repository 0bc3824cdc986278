#include "solver/condition/condition_builder.hpp"

#include <fmt/format.h>

#include <cmath>

namespace gapcheck::solver {
namespace {

template <std::size_t N>
void mark(const model::Elements<N>& elements, const std::vector<bool>& wanted, std::vector<bool>& marked) {
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (elements.part[i].value >= wanted.size() || !wanted[elements.part[i].value]) continue;
    for (const NodeIndex node : elements.nodes[i])
      if (node.value < marked.size()) marked[node.value] = true;
  }
}

/// Finite, with times in ascending order.
bool is_function_of_time(const std::vector<TimeCurve::Point>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(points[i][0]) || !std::isfinite(points[i][1])) return false;
    if (i > 0 && points[i][0] < points[i - 1][0]) return false;
  }
  return !points.empty();
}

}  // namespace

void ConditionBuilder::fail(Failure::Kind kind, std::string_view keyword, model::Place place,
                            std::string_view message) {
  if (status_.ok()) status_ = Failure{kind, fmt::format("*{}: {}", keyword, message), place};
}

void ConditionBuilder::warn(std::string_view keyword, model::Place place, std::string_view message) {
  const bool known = place.file.value < model.files.size();
  diagnostics.warning(known ? model.files[place.file.value] : "", place.line, fmt::format("*{}: {}", keyword, message));
}

std::vector<NodeIndex> ConditionBuilder::nodes(const model::NodeChoice& choice, std::string_view keyword,
                                               model::Place place) {
  if (choice.set) {
    const auto found = model.sets.nodes.find(choice.id);
    if (found != model.sets.nodes.end()) return found->second.members;
    fail(Failure::Kind::unknown_reference, keyword, place,
         fmt::format("node set {} is not defined; define it or remove the condition", choice.id));
  } else if (const auto node = model.mesh.nodes.lookup.find(choice.id)) {
    return {NodeIndex{*node}};
  } else {
    fail(Failure::Kind::unknown_reference, keyword, place,
         fmt::format("node {} is not defined; define it or remove the condition", choice.id));
  }
  return {};
}

std::vector<PartIndex> ConditionBuilder::part_set(std::int64_t id, std::string_view keyword, model::Place place) {
  const auto found = model.sets.parts.find(id);
  if (found != model.sets.parts.end()) return found->second.members;
  fail(Failure::Kind::unknown_reference, keyword, place,
       fmt::format("part set {} is not defined; define it or remove the condition", id));
  return {};
}

std::optional<std::size_t> ConditionBuilder::body(std::int64_t id, std::string_view keyword, model::Place place) {
  const auto found = structure.body_of_id.find(id);
  if (found != structure.body_of_id.end()) return found->second;
  fail(Failure::Kind::unknown_reference, keyword, place,
       fmt::format("{} is no rigid part with elements and no nodal rigid body with nodes", id));
  return std::nullopt;
}

std::shared_ptr<const TimeCurve> ConditionBuilder::curve(std::int64_t id, std::string_view keyword,
                                                         model::Place place) {
  const auto known = curves_.find(id);
  if (known != curves_.end()) return known->second;
  const auto found = model.curves.find(id);
  if (found == model.curves.end()) {
    fail(Failure::Kind::unknown_reference, keyword, place,
         fmt::format("curve {} is not defined by a *DEFINE_CURVE; define it (functions and tables are not read)", id));
    return nullptr;
  }
  std::vector<TimeCurve::Point> points = found->second.points;
  for (TimeCurve::Point& point : points) point[0] *= found->second.abscissa_time;
  if (!is_function_of_time(points)) {
    fail(
        Failure::Kind::unknown_reference, keyword, place,
        fmt::format("the times of curve {} ({}) do not rise or are not numbers", id, model.where(found->second.place)));
    return nullptr;
  }
  return curves_[id] = std::make_shared<const TimeCurve>(std::move(points));
}

Phases ConditionBuilder::phases(std::int64_t curve) const {
  const auto found = model.curves.find(curve);
  const std::int64_t sidr = found == model.curves.end() ? 0 : found->second.relaxation;
  return {sidr != 1, sidr == 1 || sidr == 2};
}

std::optional<Matrix> ConditionBuilder::system(std::int64_t id, std::string_view keyword, model::Place place) {
  const auto found = model.systems.find(id);
  if (found != model.systems.end() && found->second.fault.empty() && found->second.axes.allFinite())
    return Matrix(found->second.axes);
  fail(Failure::Kind::not_calculated, keyword, place,
       fmt::format("directions in the local system {} are not calculated: {}", id,
                   found == model.systems.end() || found->second.fault.empty() ? "its axes are not known"
                                                                               : found->second.fault));
  return std::nullopt;
}

void ConditionBuilder::use_axes(const std::vector<NodeIndex>& nodes, const Matrix& axes, std::string_view keyword,
                                model::Place place) {
  if (axes.isIdentity(1e-12)) return refuse_axes(nodes, keyword, place);
  Constraints& constraints = structure.constraints;
  std::optional<std::uint32_t> position;
  for (const NodeIndex node : nodes) {
    const std::int64_t id = structure.node_id[node.value];
    if (structure.rigid.holds(node.value))
      return fail(Failure::Kind::not_calculated, keyword, place,
                  fmt::format("node {} belongs to a rigid body, which local axes do not hold; hold the body", id));
    const Matrix* present = constraints.axes(node.value);
    if (present != nullptr ? present->isApprox(axes, 1e-12) : constraints.mask(node.value) == 0) {
      if (present != nullptr) continue;
      if (!position) position = constraints.add_axes(axes);
      constraints.set_axes(node, *position);
      continue;
    }
    return fail(Failure::Kind::not_calculated, keyword, place,
                fmt::format("node {} is held or moved in two systems of axes; give both conditions in one", id));
  }
}

void ConditionBuilder::refuse_axes(const std::vector<NodeIndex>& nodes, std::string_view keyword, model::Place place) {
  for (const NodeIndex node : nodes)
    if (structure.constraints.axes(node.value) != nullptr)
      return fail(Failure::Kind::not_calculated, keyword, place,
                  fmt::format("node {} is held or moved in two systems of axes; give both conditions in one",
                              structure.node_id[node.value]));
}

void ConditionBuilder::refuse_system(std::int64_t system, std::string_view keyword, model::Place place) {
  if (system != 0)
    fail(Failure::Kind::not_calculated, keyword, place,
         fmt::format("directions in the local system {} are not calculated; give them in the global system", system));
}

std::vector<NodeIndex> nodes_of_parts(const model::Model& model, const std::vector<bool>& wanted) {
  const model::Mesh& mesh = model.mesh;
  std::vector<bool> marked(mesh.nodes.size());
  mark(mesh.shells, wanted, marked);
  mark(mesh.solids, wanted, marked);
  mark(mesh.thick_shells, wanted, marked);
  mark(mesh.beams, wanted, marked);
  mark(mesh.discrete, wanted, marked);
  mark(mesh.masses, wanted, marked);
  mark(mesh.particles, wanted, marked);
  std::vector<NodeIndex> nodes;
  for (std::uint32_t i = 0; i < marked.size(); ++i)
    if (marked[i]) nodes.emplace_back(i);
  return nodes;
}

}  // namespace gapcheck::solver
