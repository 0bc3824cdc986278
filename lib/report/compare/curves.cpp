#include "report/compare/curves.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "report/compare/history_curves.hpp"

namespace gapcheck::report {
namespace {

using results::GlobalState;

struct GlobalCurve {
  std::string_view quantity, name;
  double GlobalState::*value;
};

constexpr std::array<GlobalCurve, 7> global_curves{{
    {"energy", "kinetic energy", &GlobalState::kinetic},
    {"energy", "internal energy", &GlobalState::internal},
    {"energy", "hourglass energy", &GlobalState::hourglass},
    {"energy", "sliding interface energy", &GlobalState::sliding},
    {"energy", "external work", &GlobalState::external},
    {"energy", "total energy", &GlobalState::total},
    {"ratio", "energy ratio", &GlobalState::ratio},
}};

/// By the wall's number; a wall that only some states have keeps those.
void add_stonewalls(const std::vector<GlobalState>& states, std::vector<Curve>& list) {
  std::map<std::int64_t, Curve> walls;
  for (const GlobalState& state : states)
    for (const GlobalState::Wall& wall : state.walls) {
      Curve& curve = walls[wall.number];
      if (curve.name.empty())
        curve = {"glstat", "energy", fmt::format("glstat stonewall energy of wall {}", wall.number), 6, {}, {}, 0};
      curve.add(state.time, wall.energy);
    }
  for (auto& [number, curve] : walls) list.push_back(std::move(curve));
}

void add_global(const std::vector<GlobalState>& states, std::vector<Curve>& list) {
  if (states.empty()) return;
  for (const GlobalCurve& entry : global_curves) {
    Curve curve{"glstat", std::string(entry.quantity), fmt::format("glstat {}", entry.name), 6, {}, {}, 0};
    for (const GlobalState& state : states) curve.add(state.time, state.*entry.value);
    list.push_back(std::move(curve));
  }
  add_stonewalls(states, list);
}

/// Finds the curves of a contact or node, and creates them when it first appears.
class CurvesById {
 public:
  explicit CurvesById(std::vector<Curve>& list) : list_(list) {}

  /// Position of the first curve; `make` appends them.
  template <class Make>
  std::size_t at(std::int64_t id, const Make& make) {
    const auto [place, is_new] = first_.try_emplace(id, list_.size());
    if (is_new) make();
    return place->second;
  }

 private:
  std::vector<Curve>& list_;
  std::unordered_map<std::int64_t, std::size_t> first_;
};

/// x, y, z and resultant.
void add_vector(const Vector& value, double time, std::vector<Curve>& list, std::size_t first) {
  for (std::size_t axis = 0; axis < 3; ++axis) list[first + axis].add(time, value[static_cast<Eigen::Index>(axis)]);
  list[first + 3].add(time, value.stableNorm());
}

void make_vector(const std::string& file, const std::string& quantity, const std::string& whose,
                 std::vector<Curve>& list) {
  for (const char axis : {'x', 'y', 'z'})
    list.push_back({file, quantity, fmt::format("{} {} {}-{}", file, whose, axis, quantity), 6, {}, {}, 0});
  list.push_back({file, quantity, fmt::format("{} {} resultant {}", file, whose, quantity), 6, {}, {}, 0});
}

void add_forces(const results::InterfaceHistory& history, std::vector<Curve>& list) {
  CurvesById groups(list);
  for (const results::InterfaceStates& state : history.states)
    for (const results::InterfaceState& contact : state.contacts) {
      const std::size_t first = groups.at(contact.contact, [&] {
        for (const char side : {'A', 'B'})
          make_vector("rcforc", "force", fmt::format("contact {} side {}", contact.contact, side), list);
        for (std::size_t i = list.size() - 8; i < list.size(); ++i) list[i].contact = contact.contact;
      });
      for (std::size_t side = 0; side < 2; ++side) add_vector(contact.force[side], state.time, list, first + 4 * side);
    }
}

void add_energies(const results::InterfaceHistory& history, std::vector<Curve>& list) {
  CurvesById groups(list);
  for (const results::InterfaceStates& state : history.states)
    for (const results::InterfaceState& contact : state.contacts) {
      const std::size_t first = groups.at(contact.contact, [&] {
        for (const char* what : {"energy of side A", "energy of side B", "friction energy"})
          list.push_back({"sleout",
                          "energy",
                          fmt::format("sleout contact {} {}", contact.contact, what),
                          4,
                          {},
                          {},
                          0,
                          contact.contact});
      });
      list[first].add(state.time, contact.energy[0]);
      list[first + 1].add(state.time, contact.energy[1]);
      list[first + 2].add(state.time, contact.friction);
    }
}

void add_nodes(const results::NodeHistory& history, std::vector<Curve>& list) {
  CurvesById groups(list);
  for (const results::NodeStates& state : history.states)
    for (const results::NodeState& node : state.nodes) {
      const std::size_t first = groups.at(node.node, [&] {
        make_vector("nodout", "displacement", fmt::format("node {}", node.node), list);
        make_vector("nodout", "velocity", fmt::format("node {}", node.node), list);
      });
      add_vector(node.displacement, state.time, list, first);
      add_vector(node.velocity, state.time, list, first + 4);
    }
}

}  // namespace

void Curve::add(double time, double value) {
  while (!times.empty() && !(times.back() < time)) {
    times.pop_back();
    values.pop_back();
  }
  if (!std::isfinite(value)) {
    ++not_numbers;
    return;
  }
  times.push_back(time);
  values.push_back(value);
}

std::vector<Curve> part_curves(const results::PartHistory& history) {
  constexpr std::array<std::pair<std::string_view, double results::PartState::*>, 5> energies{
      {{"internal energy", &results::PartState::internal},
       {"kinetic energy", &results::PartState::kinetic},
       {"hourglass energy", &results::PartState::hourglass},
       {"eroded internal energy", &results::PartState::eroded_internal},
       {"eroded hourglass energy", &results::PartState::eroded_hourglass}}};
  std::vector<Curve> list;
  CurvesById parts(list);
  for (const results::PartStates& state : history.states)
    for (const results::PartState& part : state.parts) {
      const std::string whose = fmt::format("part {}", part.part);
      const std::size_t first = parts.at(part.part, [&] {
        for (const auto& [what, value] : energies)
          list.push_back({"matsum", "energy", fmt::format("matsum {} {}", whose, what), 5, {}, {}, 0});
        make_vector("matsum", "momentum", whose, list);
        make_vector("matsum", "velocity", whose, list);
      });
      for (std::size_t i = 0; i < energies.size(); ++i) list[first + i].add(state.time, part.*energies[i].second);
      add_vector(part.momentum, state.time, list, first + energies.size());
      add_vector(part.velocity, state.time, list, first + energies.size() + 4);
    }
  return list;
}

std::vector<Curve> curves(const results::RunResults& run) {
  std::vector<Curve> list;
  add_global(run.glstat, list);
  add_forces(run.rcforc, list);
  add_energies(run.sleout, list);
  add_nodes(run.nodout, list);
  add_history_curves(run, list);
  return list;
}

}  // namespace gapcheck::report
