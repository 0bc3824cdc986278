#include "contact/stiffness/contact_timestep.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>
#include <string_view>
#include <tuple>

#include "base/parallel.hpp"
#include "contact/mesh/node_sums.hpp"
#include "contact/stiffness/node_masses.hpp"

namespace gapcheck::contact {
namespace {

constexpr std::size_t springs_per_task = 16384;
constexpr double infinite = std::numeric_limits<double>::infinity();
/// Rounding in sums of equal terms must not decide which of several equal nodes controls.
constexpr double equal_squared_steps = 1e-12;

/// The node of a side with the lowest id; none where it has none.
NodeIndex lowest_node(const model::Nodes& all, const ContactSide& side) {
  NodeIndex lowest = none<NodeIndex>;
  const auto take = [&](NodeIndex n) {
    if (lowest == none<NodeIndex> || all.id[n.value] < all.id[lowest.value]) lowest = n;
  };
  for (const auto& nodes : side.selection.segments.nodes) std::for_each(nodes.begin(), nodes.end(), take);
  std::for_each(side.selection.nodes.begin(), side.selection.nodes.end(), take);
  return lowest;
}

/// A triangle's last corner, which is there twice, counts twice in the printed step.
std::size_t corners_with_spring(const model::SegmentNodes& nodes, TimestepLimit limit) {
  return limit == TimestepLimit::printed ? nodes.size() : corner_count(nodes);
}

/// Squared step of a node of mass m with springs of stiffness k against a surface that does not move.
struct AgainstSurface {
  TimestepLimit limit;
  double operator()(double m, double k) const { return (limit == TimestepLimit::printed ? 0.5 : 4) * m / k; }
};

/// The same against a free node.
struct AgainstNode {
  TimestepLimit limit;
  const SideTimestep& other;
  double operator()(double m, double k) const {
    const double squared = limit == TimestepLimit::printed ? 1 : 4;
    return squared * m * other.mass / ((m + other.mass) * std::min(k, other.stiffness));
  }
};

}  // namespace

TimestepEstimate::TimestepEstimate(const model::Model& model, const ElementSizes& sizes)
    : model_(model),
      springs_(model, sizes),
      sizes_(sizes),
      printed_masses_(node_masses(model, sizes, true)),
      sums_(model.mesh.nodes.size()) {}

template <class SquaredStep>
NodeIndex TimestepEstimate::controlling(const Segments& s, TimestepLimit limit, const SquaredStep& squared_step) {
  const std::vector<double>& mass = masses(limit);
  const auto squared_at = [&](std::uint32_t n) {
    const double k = sums_[n].value(), m = mass[n];
    const double squared = m > 0 && k > 0 ? squared_step(m, k) : infinite;
    return squared > 0 ? squared : infinite;
  };
  double least = infinite;
  NodeIndex node = none<NodeIndex>;
  // The one with the lower id.
  const auto lower = [&](NodeIndex a, NodeIndex b) {
    if (a == none<NodeIndex> || b == none<NodeIndex>) return a == none<NodeIndex> ? b : a;
    return model_.mesh.nodes.id[b.value] < model_.mesh.nodes.id[a.value] ? b : a;
  };
  std::mutex mutex;
  if (most_of_the_mesh(s)) {
    squared_.resize(sums_.size());
    parallel_for(sums_.size(), springs_per_task, [&](std::size_t begin, std::size_t end) {
      double least_here = infinite;
      for (std::size_t n = begin; n < end; ++n) {
        squared_[n] = squared_at(static_cast<std::uint32_t>(n));
        least_here = std::min(least_here, squared_[n]);
      }
      const std::scoped_lock lock(mutex);
      least = std::min(least, least_here);
    });
    if (least == infinite) return node;
    const double limit_of_equal = least * (1 + equal_squared_steps);
    parallel_for(sums_.size(), springs_per_task, [&](std::size_t begin, std::size_t end) {
      NodeIndex here = none<NodeIndex>;
      for (std::size_t n = begin; n < end; ++n)
        if (squared_[n] <= limit_of_equal) here = lower(here, to_index<NodeIndex>(n));
      const std::scoped_lock lock(mutex);
      node = lower(node, here);
    });
    return node;
  }
  for (const auto& nodes : s.nodes)
    for (const NodeIndex n : nodes) least = std::min(least, squared_at(n.value));
  if (least == infinite) return node;
  for (const auto& nodes : s.nodes)
    for (const NodeIndex n : nodes)
      if (squared_at(n.value) <= least * (1 + equal_squared_steps)) node = lower(node, n);
  return node;
}

void TimestepEstimate::sum(const Segments& s, double scale, TimestepLimit limit) {
  const bool printed = limit == TimestepLimit::printed;
  if (!printed && masses_.empty()) masses_ = node_masses(model_, sizes_);
  corners_.resize(s.size());
  parallel_for(s.size(), springs_per_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      // Beams have their own springs only in types 26; the printed step does not know them.
      const SegmentSpring spring =
          s.element_kind[i] == model::ElementKind::beam ? SegmentSpring{} : springs_(s, i, scale, printed);
      corners_[i] = {spring.weight, spring.weight * spring.stiffness};
    }
  });
  sum_at_nodes(sums_, s.nodes, [&](std::size_t i, const auto& add) {
    if (corners_[i].weight > 0)
      for (std::size_t c = 0; c < corners_with_spring(s.nodes[i], limit); ++c) add(s.nodes[i][c], corners_[i]);
  });
}

void TimestepEstimate::clear(const Segments& s) {
  if (most_of_the_mesh(s)) {
    parallel_for(sums_.size(), springs_per_task, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n) sums_[n] = {};
    });
    return;
  }
  for (const auto& nodes : s.nodes)
    for (const NodeIndex n : nodes) sums_[n.value] = {};
}

template <class SquaredStep>
SideTimestep TimestepEstimate::least(const Segments& s, TimestepLimit limit, const SquaredStep& squared_step) {
  SideTimestep result;
  result.node = controlling(s, limit, squared_step);
  if (result.node == none<NodeIndex>) return result;
  const auto id_of = [&](PartIndex part) { return model_.part(part).id; };
  std::mutex mutex;
  parallel_for(s.size(), springs_per_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (!(corners_[i].weight > 0)) continue;
      for (std::size_t c = 0; c < corners_with_spring(s.nodes[i], limit); ++c) {
        if (s.nodes[i][c] != result.node) continue;
        const PartIndex part = part_of(model_.mesh, s, i);
        const std::scoped_lock lock(mutex);
        if (result.part == none<PartIndex> || (part != none<PartIndex> && id_of(part) < id_of(result.part)))
          result.part = part;
      }
    }
  });
  result.mass = masses(limit)[result.node.value];
  result.stiffness = sums_[result.node.value].value();
  result.timestep = std::sqrt(squared_step(result.mass, result.stiffness));
  return result;
}

SideTimestep TimestepEstimate::side(const Segments& s, double scale, TimestepLimit limit) {
  sum(s, scale, limit);
  const SideTimestep result = least(s, limit, AgainstSurface{limit});
  clear(s);
  return result;
}

SideTimestep TimestepEstimate::side_against(const Segments& s, double scale, const SideTimestep& other,
                                            TimestepLimit limit) {
  sum(s, scale, limit);
  const SideTimestep result = least(s, limit, AgainstNode{limit, other});
  clear(s);
  return result;
}

std::pair<SideTimestep, SideTimestep> TimestepEstimate::side_against_itself(const Segments& s, double scale,
                                                                            TimestepLimit limit) {
  sum(s, scale, limit);
  const SideTimestep alone = least(s, limit, AgainstSurface{limit});
  const SideTimestep pair = least(s, limit, AgainstNode{limit, alone});
  clear(s);
  return {alone, pair};
}

bool has_timestep(const ContactType& type) {
  if (type.family == Family::constraint || ties_by_constraint(type)) return false;
  switch (type.code) {
    case ContactCode::unknown:
    case ContactCode::rigid_nodes:
    case ContactCode::rigid_bodies:
    case ContactCode::single_edge:
    case ContactCode::draw_bead:
      return false;
    default:
      return true;
  }
}

PredictedTimesteps predict_timesteps(const model::Model& model, SurfaceStore& surfaces,
                                     std::span<const ContactIndex> contacts) {
  PredictedTimesteps all;
  const ElementSizes sizes = element_sizes(model);
  all.element = smallest_element_timestep(model, sizes);
  all.timesteps.element_timestep = all.element.timestep;
  all.run = run_timestep(model.controls, all.element.timestep);
  std::optional<TimestepEstimate> first_use;  // a deck without such contacts needs no masses of nodes
  auto& list = all.timesteps.surface_timesteps;
  double& least = all.timesteps.contact_timestep;
  for (const ContactIndex c : contacts) {
    const model::Contact& contact = model.contact(c);
    if (!contact.known || contact.own_layout || !has_timestep(classify(contact))) continue;
    const ContactSurfaces& s = surfaces.at(c);
    const bool mortar = s.type.family == Family::mortar;
    if (contact.soft == 2 && !mortar && has_soft_2(s.type)) continue;  // the solver prints none
    TimestepEstimate& estimate = first_use ? *first_use : first_use.emplace(model, sizes);
    const bool transducer = s.type.code == ContactCode::transducer;
    const double scale_a = model.controls.slsfac * contact.sfs, scale_b = model.controls.slsfac * contact.sfm;
    const Segments &a = s.a.selection.segments, &b = s.b.selection.segments;
    // The springs that a side's nodes have against the other side's, or its own.
    const auto unstable = [&](char letter, const Segments& segments, double scale) -> std::optional<UnstableSide> {
      const auto surface = static_cast<std::uint32_t>(list.size() - 1);
      SideTimestep alone, other, pair;
      if (s.two_sided())
        alone = estimate.side(segments, scale, TimestepLimit::spring);
      else
        std::tie(alone, pair) = estimate.side_against_itself(segments, scale, TimestepLimit::spring);
      if (alone.timestep < all.run) return UnstableSide{surface, alone, true};
      other = alone;
      if (s.two_sided())
        other = letter == 'A' ? estimate.side(b, scale_b, TimestepLimit::spring)
                              : estimate.side(a, scale_a, TimestepLimit::spring);
      if (!(other.mass > 0) || (other.part != none<PartIndex> && model.rigid(other.part))) return std::nullopt;
      if (s.two_sided()) pair = estimate.side_against(segments, scale, other, TimestepLimit::spring);
      if (!(pair.timestep < all.run) || model.rigid(pair.part)) return std::nullopt;
      return UnstableSide{surface, pair, false};
    };
    const auto add = [&](char letter, const ContactSide& side, SideTimestep found, double scale) {
      if (found.node == none<NodeIndex> && !side.beams_alone) found.node = lowest_node(model.mesh.nodes, side);
      if (found.node == none<NodeIndex> && !side.beams_alone) return;
      list.push_back({c.value, letter, s.type.printed(), found.timestep,
                      found.node == none<NodeIndex> ? 0 : model.mesh.nodes.id[found.node.value],
                      found.part == none<PartIndex> ? 0 : model.part(found.part).id.value});
      if (found.timestep >= no_timestep_limit) return;
      if (least == 0 || found.timestep < least) least = found.timestep;
      if (transducer || mortar || !(found.timestep < all.run)) return;  // neither has such springs
      if (const auto found_unstable = unstable(letter, side.selection.segments, scale))
        all.unstable.push_back(*found_unstable);
    };
    SideTimestep of_a = estimate.side(a, scale_a), of_b = s.two_sided() ? estimate.side(b, scale_b) : SideTimestep{};
    if (transducer && of_a.mass > 0 && of_b.mass > 0) {
      const SideTimestep alone = of_a;
      of_a = estimate.side_against(a, scale_a, of_b, TimestepLimit::printed);
      of_b = estimate.side_against(b, scale_b, alone, TimestepLimit::printed);
    }
    add('A', s.a, of_a, scale_a);
    if (s.two_sided()) add('B', s.b, of_b, scale_b);
  }
  return all;
}

double run_timestep(const model::Controls& controls, double element_timestep) {
  return controls.tssfac * std::max(element_timestep, std::abs(controls.dt2ms));
}

}  // namespace gapcheck::contact
