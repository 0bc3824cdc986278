#include "results/curves/binout_states.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "results/curves/binout_histories.hpp"

namespace gapcheck::results {
namespace {

GlobalState global_state(const BinoutRow& row) {
  GlobalState state;
  state.time = row.number("time");
  state.time_step = row.number("time_step");
  state.cycle = static_cast<std::uint64_t>(std::clamp(row.number("cycle", 1), 0.0, 9e15));
  state.kinetic = row.number("kinetic_energy");
  state.internal = row.number("internal_energy");
  state.springs = row.number("spring_and_damper_energy");
  state.hourglass = row.number("hourglass_energy");
  state.damping = row.number("system_damping_energy");
  state.sliding = row.number("sliding_interface_energy");
  state.external = row.number("external_work");
  state.eroded_internal = row.number("eroded_internal_energy");
  state.eroded_hourglass = row.number("eroded_hourglass_energy");
  state.total = row.number("total_energy");
  state.ratio = row.number("energy_ratio", 1);
  state.ratio_without_eroded = row.number("energy_ratio_wo_eroded", 1);
  for (const double energy : row.reals("stonewall_energy"))
    state.walls.push_back({static_cast<std::int64_t>(state.walls.size()) + 1, energy});
  state.velocity = {row.number("global_x_velocity"), row.number("global_y_velocity"), row.number("global_z_velocity")};
  return state;
}

/// The rows of a contact follow each other.
InterfaceStates contact_forces(const BinoutMeta& meta, const BinoutRow& row) {
  const std::vector<std::int64_t>& sides = meta.list("side");
  const std::size_t count = meta.ids().size();
  const BinoutVectors force = row.vectors("force", count), moment = row.vectors("moment", count);
  InterfaceStates state;
  state.time = row.number("time");
  for (std::size_t i = 0; i < count; ++i) {
    if (meta.is_single(i)) continue;
    const std::size_t side = i < sides.size() && sides[i] == 1 ? 1 : 0;
    if (state.contacts.empty() || state.contacts.back().contact != meta.ids()[i])
      state.contacts.emplace_back().contact = meta.ids()[i];
    state.contacts.back().force[side] = force.at(i);
    state.contacts.back().moment[side] = moment.at(i);
  }
  return state;
}

/// The energies of side B of all contacts, or only of those that are no single surfaces.
std::size_t rows_of_side_b(const BinoutMeta& meta, const BinoutRow& row, std::string_view name) {
  const std::size_t count = meta.ids().size();
  std::size_t two_sided = 0;
  for (std::size_t i = 0; i < count; ++i) two_sided += meta.is_single(i) ? 0 : 1;
  return row.size_of(name) == count ? count : two_sided;
}

InterfaceStates contact_energies(const BinoutMeta& meta, const BinoutRow& row) {
  const std::size_t count = meta.ids().size();
  const bool new_words = row.has("surfa");
  const std::string_view b_name = new_words ? "surfb" : "master";
  const std::size_t b_count = rows_of_side_b(meta, row, b_name);
  const BinoutColumn a = row.column(new_words ? "surfa" : "slave", count), b = row.column(b_name, b_count),
                     friction = row.column("friction_energy", count);
  InterfaceStates state;
  state.time = row.number("time");
  std::size_t at_b = 0;
  for (std::size_t i = 0; i < count; ++i) {
    InterfaceState& contact = state.contacts.emplace_back();
    contact.contact = meta.ids()[i];
    const bool has_b = b_count == count || !meta.is_single(i);
    contact.energy = {a.at(i), has_b ? b.at(at_b++) : 0};
    contact.friction = friction.at(i);
  }
  return state;
}

PartStates part_states(const BinoutMeta& meta, const BinoutRow& row) {
  const std::size_t count = meta.ids().size();
  const auto column = [&](std::string_view name) { return row.column(name, count); };
  const BinoutColumn internal = column("internal_energy"), kinetic = column("kinetic_energy"),
                     hourglass = column("hourglass_energy"), eroded_internal = column("eroded_internal_energy"),
                     eroded_hourglass = column("eroded_hourglass_energy");
  const BinoutVectors momentum = row.vectors("momentum", count), velocity = row.vectors("rbvelocity", count);
  PartStates state;
  state.time = row.number("time");
  for (std::size_t i = 0; i < count; ++i)
    state.parts.push_back({meta.ids()[i], internal.at(i), kinetic.at(i), hourglass.at(i), eroded_internal.at(i),
                           eroded_hourglass.at(i), momentum.at(i), velocity.at(i)});
  return state;
}

NodeStates node_states(const BinoutMeta& meta, const BinoutRow& row) {
  const std::size_t count = meta.ids().size();
  const BinoutVectors displacement = row.vectors("displacement", count), velocity = row.vectors("velocity", count),
                      acceleration = row.vectors("acceleration", count), position = row.vectors("coordinate", count),
                      rotation = row.vectors("displacement", count, "r"), spin = row.vectors("velocity", count, "r"),
                      spin_rate = row.vectors("acceleration", count, "r");
  NodeStates state;
  state.time = row.number("time");
  for (std::size_t i = 0; i < count; ++i)
    state.nodes.push_back({meta.ids()[i], displacement.at(i), velocity.at(i), acceleration.at(i), position.at(i),
                           rotation.at(i), spin.at(i), spin_rate.at(i)});
  return state;
}

/// A state has what its branch needs.
bool is_complete(std::string_view branch, const BinoutMeta& meta, const BinoutRow& row) {
  const std::size_t count = meta.ids().size();
  if (!std::isfinite(row.number("time", std::numeric_limits<double>::quiet_NaN()))) return false;
  if (branch == "glstat") return row.has("total_energy");
  if (branch == "rcforc") return row.has_columns({"x_force", "y_force", "z_force"}, count);
  if (branch == "matsum") return row.has_columns({"internal_energy", "kinetic_energy"}, count);
  if (branch == "nodout") return row.has_columns({"x_displacement", "y_displacement", "z_displacement"}, count);
  const auto has_energies = [&](std::string_view a, std::string_view b) {
    const std::size_t rows_b = rows_of_side_b(meta, row, b);
    return row.has_columns({a}, count) && (rows_b == 0 || row.has_columns({b}, rows_b));
  };
  return has_energies("surfa", "surfb") || has_energies("slave", "master");
}

}  // namespace

bool add_binout_state(std::string_view branch, const BinoutMeta& meta, const BinoutRow& row, RunResults& run) {
  if (is_history_branch(branch)) return add_history_state(branch, meta, row, run);
  if (!is_complete(branch, meta, row)) return false;
  if (branch == "glstat") run.glstat.push_back(global_state(row));
  if (branch == "rcforc") run.rcforc.states.push_back(contact_forces(meta, row));
  if (branch == "sleout") run.sleout.states.push_back(contact_energies(meta, row));
  if (branch == "matsum") run.matsum.states.push_back(part_states(meta, row));
  if (branch == "nodout") run.nodout.states.push_back(node_states(meta, row));
  return true;
}

}  // namespace gapcheck::results
