#include "results/curves/binout_write.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/number.hpp"
#include "results/text/binout_name.hpp"

namespace gapcheck::results {
namespace {

constexpr std::size_t title_bytes = 80;

/// A column of a list.
template <class List, class Member>
std::vector<double> column(const List& list, Member member) {
  std::vector<double> values;
  values.reserve(list.size());
  for (const auto& entry : list) values.push_back(entry.*member);
  return values;
}

template <class List, class Member>
std::vector<Vector> vector_column(const List& list, Member member) {
  std::vector<Vector> values;
  values.reserve(list.size());
  for (const auto& entry : list) values.push_back(entry.*member);
  return values;
}

template <class List, class Member>
void ids(BinoutWriter& binout, const List& list, Member member) {
  std::vector<std::int64_t> values;
  for (const auto& entry : list) values.push_back(entry.*member);
  binout.file().integers("ids", values);
}

}  // namespace

Result<BinoutWriter> BinoutWriter::create(const std::string& path, const FileHeader& header,
                                          const LsdaWriteSettings& settings) {
  auto file = LsdaWriter::create(path, settings);
  if (!file) return file.error();
  return BinoutWriter(std::move(file).value(), header);
}

bool BinoutWriter::begin_metadata(std::string_view branch) {
  if (has(branch)) return false;
  states_.emplace(branch, 0);
  file_.change_directory(fmt::format("/{}/metadata", branch));
  file_.text("title", column_text(header_.title, title_bytes));
  const std::size_t space = std::min(header_.program.find(' '), header_.program.size());
  file_.text("version", binout_program);
  file_.text("revision", column_text(trimmed(std::string_view(header_.program).substr(space)), 10));
  file_.text("date", std::string(10, ' '));  // equal runs have equal files
  return true;
}

void BinoutWriter::begin_state(std::string_view branch, double time) {
  begin_metadata(branch);
  file_.change_directory(fmt::format("/{}/d{:06}", branch, ++states_.find(branch)->second));
  file_.real("time", time);
}

void BinoutWriter::legend(std::vector<LegendEntry> entries) {
  if (entries.empty()) return;
  const auto before = [](const LegendEntry& a, const LegendEntry& b) { return a.id < b.id; };
  std::stable_sort(entries.begin(), entries.end(), before);
  std::string titles;
  std::vector<std::int64_t> numbers;
  for (const LegendEntry& entry : entries) {
    titles += column_text(entry.title, title_bytes);
    numbers.push_back(entry.id);
  }
  file_.text("legend", titles);
  file_.integers("legend_ids", numbers);
}

void BinoutWriter::vectors(std::string_view word, const std::vector<Vector>& values, std::string_view prefix) {
  std::vector<double> one(values.size());
  for (const int axis : {0, 1, 2}) {
    for (std::size_t i = 0; i < values.size(); ++i) one[i] = values[i][axis];
    file_.reals(fmt::format("{}{}_{}", prefix, "xyz"[axis], word), one);
  }
}

void add_glstat(BinoutWriter& binout, const GlobalState& state) {
  binout.begin_state("glstat", state.time);
  LsdaWriter& file = binout.file();
  file.integer("cycle", static_cast<std::int64_t>(state.cycle));
  file.real("time_step", state.time_step);
  file.real("kinetic_energy", state.kinetic);
  file.real("internal_energy", state.internal);
  if (!state.walls.empty()) file.reals("stonewall_energy", column(state.walls, &GlobalState::Wall::energy));
  file.real("spring_and_damper_energy", state.springs);
  file.real("hourglass_energy", state.hourglass);
  file.real("system_damping_energy", state.damping);
  file.real("sliding_interface_energy", state.sliding);
  file.real("external_work", state.external);
  file.real("eroded_kinetic_energy", 0);
  file.real("eroded_internal_energy", state.eroded_internal);
  file.real("eroded_hourglass_energy", state.eroded_hourglass);
  file.real("total_energy", state.total);
  file.real("energy_ratio", state.ratio);
  file.real("energy_ratio_wo_eroded", state.ratio_without_eroded);
  for (const int axis : {0, 1, 2}) file.real(fmt::format("global_{}_velocity", "xyz"[axis]), state.velocity[axis]);
  file.integer("nzc", static_cast<std::int64_t>(state.nanoseconds));
}

void add_matsum(BinoutWriter& binout, double time, const std::vector<LegendEntry>& titles,
                const std::vector<PartState>& parts) {
  if (binout.begin_metadata("matsum")) {
    ids(binout, parts, &PartState::part);
    binout.legend(titles);
  }
  binout.begin_state("matsum", time);
  LsdaWriter& file = binout.file();
  file.reals("internal_energy", column(parts, &PartState::internal));
  file.reals("kinetic_energy", column(parts, &PartState::kinetic));
  file.reals("hourglass_energy", column(parts, &PartState::hourglass));
  binout.vectors("momentum", vector_column(parts, &PartState::momentum));
  binout.vectors("rbvelocity", vector_column(parts, &PartState::velocity));
  file.reals("eroded_internal_energy", column(parts, &PartState::eroded_internal));
  file.reals("eroded_kinetic_energy", std::vector<double>(parts.size()));
  file.reals("eroded_hourglass_energy", column(parts, &PartState::eroded_hourglass));
}

void add_nodout(BinoutWriter& binout, const std::vector<LegendEntry>& titles, const NodeStates& state) {
  if (binout.begin_metadata("nodout")) {
    ids(binout, state.nodes, &NodeState::node);
    binout.legend(titles);
  }
  binout.begin_state("nodout", state.time);
  binout.file().integer("cycle", static_cast<std::int64_t>(state.cycle));
  binout.vectors("displacement", vector_column(state.nodes, &NodeState::displacement));
  binout.vectors("velocity", vector_column(state.nodes, &NodeState::velocity));
  binout.vectors("acceleration", vector_column(state.nodes, &NodeState::acceleration));
  binout.vectors("coordinate", vector_column(state.nodes, &NodeState::position));
  binout.vectors("displacement", vector_column(state.nodes, &NodeState::rotation), "r");
  binout.vectors("velocity", vector_column(state.nodes, &NodeState::angular_velocity), "r");
  binout.vectors("acceleration", vector_column(state.nodes, &NodeState::angular_acceleration), "r");
}

void add_rcforc(BinoutWriter& binout, const std::vector<LegendEntry>& titles, const InterfaceStates& state) {
  std::vector<std::int64_t> contacts, sides, single;
  std::vector<Vector> force, moment;
  for (const InterfaceState& contact : state.contacts)
    for (const std::size_t side : {0u, 1u}) {
      contacts.push_back(contact.contact);
      sides.push_back(static_cast<std::int64_t>(side));
      single.push_back(contact.single_surface ? 1 : 0);
      force.push_back(contact.single_surface ? Vector(Vector::Zero()) : contact.force[side]);
      moment.push_back(contact.single_surface ? Vector(Vector::Zero()) : contact.moment[side]);
    }
  LsdaWriter& file = binout.file();
  if (binout.begin_metadata("rcforc")) {
    file.integers("ids", contacts);
    file.integers("side", sides);
    file.integers("single", single);
    binout.legend(titles);
  }
  binout.begin_state("rcforc", state.time);
  binout.vectors("force", force);
  file.reals("mass", std::vector<double>(force.size()));
  binout.vectors("moment", moment);
}

void add_sleout(BinoutWriter& binout, const std::vector<LegendEntry>& titles, const InterfaceStates& state) {
  std::vector<std::int64_t> single;
  std::vector<double> a, b, friction;
  double total_b = 0;
  for (const InterfaceState& contact : state.contacts) {
    single.push_back(contact.single_surface ? 1 : 0);
    a.push_back(contact.energy[0]);
    if (!contact.single_surface) b.push_back(contact.energy[1]);
    total_b += contact.energy[1];
    friction.push_back(contact.friction);
  }
  LsdaWriter& file = binout.file();
  if (binout.begin_metadata("sleout")) {
    ids(binout, state.contacts, &InterfaceState::contact);
    file.integers("single_sided", single);
    binout.legend(titles);
  }
  binout.begin_state("sleout", state.time);
  const auto sum = [](const std::vector<double>& values) {
    double total = 0;
    for (const double value : values) total += value;
    return total;
  };
  file.integer("cycle", static_cast<std::int64_t>(state.cycle));
  file.reals("slave", a);
  file.reals("master", b);
  file.reals("friction_energy", friction);
  file.real("total_slave", sum(a));
  file.real("total_master", total_b);
  file.real("total_energy", sum(a) + total_b);
  file.real("total_friction", sum(friction));
}

}  // namespace gapcheck::results
