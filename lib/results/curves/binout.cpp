#include "results/curves/binout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "base/file_bytes.hpp"
#include "results/curves/lsda.hpp"

namespace gapcheck::results {
namespace {

/// A value for each id; zeros if the file has no such array.
class BinoutColumn {
 public:
  BinoutColumn(const LsdaArray* array, std::size_t count)
      : array_(array != nullptr && array->size() == count ? array : nullptr) {}
  [[nodiscard]] double at(std::size_t i) const { return array_ != nullptr ? array_->real(i) : 0; }

 private:
  const LsdaArray* array_;
};

struct BinoutVectors {
  BinoutColumn x, y, z;
  [[nodiscard]] Vector at(std::size_t i) const { return {x.at(i), y.at(i), z.at(i)}; }
};

/// The arrays in one directory of a file: a state, or the metadata of all states. Views into the file.
class BinoutRow {
 public:
  void add(const LsdaArray& array) { arrays_.insert_or_assign(std::string(array.name()), array); }
  void clear() { arrays_.clear(); }
  [[nodiscard]] bool empty() const { return arrays_.empty(); }
  [[nodiscard]] bool has(std::string_view name) const { return find(name) != nullptr; }
  /// All of these have `count` floating point numbers: a state cannot ask for more memory than the file gives it.
  [[nodiscard]] bool has_columns(std::initializer_list<std::string_view> names, std::size_t count) const {
    return std::all_of(names.begin(), names.end(), [&](std::string_view name) {
      const LsdaArray* array = find(name);
      return array != nullptr && array->is_real() && array->size() == count;
    });
  }

  /// One number; `other` if there is none.
  [[nodiscard]] double number(std::string_view name, double other = 0) const {
    const LsdaArray* array = find(name);
    return array != nullptr && array->size() > 0 ? array->real(0) : other;
  }
  [[nodiscard]] BinoutColumn column(std::string_view name, std::size_t count) const { return {find(name), count}; }
  /// The columns "x_force", "y_force", "z_force"; with `prefix` "r" "rx_force", …
  [[nodiscard]] BinoutVectors vectors(std::string_view word, std::size_t count, std::string_view prefix = "") const {
    const auto of = [&](char axis) { return column(fmt::format("{}{}_{}", prefix, axis, word), count); };
    return {of('x'), of('y'), of('z')};
  }
  [[nodiscard]] std::vector<std::int64_t> integers(std::string_view name) const {
    std::vector<std::int64_t> values;
    if (const LsdaArray* array = find(name))
      for (std::size_t i = 0; i < array->size(); ++i) values.push_back(array->integer(i));
    return values;
  }

 private:
  [[nodiscard]] const LsdaArray* find(std::string_view name) const {
    const auto found = arrays_.find(name);
    return found == arrays_.end() ? nullptr : &found->second;
  }
  std::map<std::string, LsdaArray, std::less<>> arrays_;
};

/// The metadata of one branch.
struct BinoutMeta {
  BinoutRow row;
  std::vector<std::int64_t> ids, sides;
};

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
  state.velocity = {row.number("global_x_velocity"), row.number("global_y_velocity"), row.number("global_z_velocity")};
  return state;
}

/// The rows of a contact follow each other.
InterfaceStates contact_forces(const BinoutMeta& meta, const BinoutRow& row) {
  const std::size_t count = meta.ids.size();
  const BinoutVectors force = row.vectors("force", count), moment = row.vectors("moment", count);
  InterfaceStates state;
  state.time = row.number("time");
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t side = i < meta.sides.size() && meta.sides[i] == 1 ? 1 : 0;
    if (state.contacts.empty() || state.contacts.back().contact != meta.ids[i])
      state.contacts.emplace_back().contact = meta.ids[i];
    state.contacts.back().force[side] = force.at(i);
    state.contacts.back().moment[side] = moment.at(i);
  }
  return state;
}

InterfaceStates contact_energies(const BinoutMeta& meta, const BinoutRow& row) {
  const std::size_t count = meta.ids.size();
  const bool new_words = row.has("surfa");
  const BinoutColumn a = row.column(new_words ? "surfa" : "slave", count),
                     b = row.column(new_words ? "surfb" : "master", count),
                     friction = row.column("friction_energy", count);
  InterfaceStates state;
  state.time = row.number("time");
  for (std::size_t i = 0; i < count; ++i) {
    InterfaceState& contact = state.contacts.emplace_back();
    contact.contact = meta.ids[i];
    contact.energy = {a.at(i), b.at(i)};
    contact.friction = friction.at(i);
  }
  return state;
}

PartStates part_states(const BinoutMeta& meta, const BinoutRow& row) {
  const std::size_t count = meta.ids.size();
  const auto column = [&](std::string_view name) { return row.column(name, count); };
  const BinoutColumn internal = column("internal_energy"), kinetic = column("kinetic_energy"),
                     hourglass = column("hourglass_energy"), eroded_internal = column("eroded_internal_energy"),
                     eroded_hourglass = column("eroded_hourglass_energy");
  const BinoutVectors momentum = row.vectors("momentum", count), velocity = row.vectors("rbvelocity", count);
  PartStates state;
  state.time = row.number("time");
  for (std::size_t i = 0; i < count; ++i)
    state.parts.push_back({meta.ids[i], internal.at(i), kinetic.at(i), hourglass.at(i), eroded_internal.at(i),
                           eroded_hourglass.at(i), momentum.at(i), velocity.at(i)});
  return state;
}

NodeStates node_states(const BinoutMeta& meta, const BinoutRow& row) {
  const std::size_t count = meta.ids.size();
  const BinoutVectors displacement = row.vectors("displacement", count), velocity = row.vectors("velocity", count),
                      acceleration = row.vectors("acceleration", count), position = row.vectors("coordinate", count),
                      rotation = row.vectors("displacement", count, "r"), spin = row.vectors("velocity", count, "r"),
                      spin_rate = row.vectors("acceleration", count, "r");
  NodeStates state;
  state.time = row.number("time");
  for (std::size_t i = 0; i < count; ++i)
    state.nodes.push_back({meta.ids[i], displacement.at(i), velocity.at(i), acceleration.at(i), position.at(i),
                           rotation.at(i), spin.at(i), spin_rate.at(i)});
  return state;
}

/// A state has what its branch needs.
bool is_complete(std::string_view branch, const BinoutMeta& meta, const BinoutRow& row) {
  const std::size_t count = meta.ids.size();
  if (!std::isfinite(row.number("time", std::numeric_limits<double>::quiet_NaN()))) return false;
  if (branch == "glstat") return row.has("total_energy");
  if (branch == "rcforc") return row.has_columns({"x_force", "y_force", "z_force"}, count);
  if (branch == "matsum") return row.has_columns({"internal_energy", "kinetic_energy"}, count);
  if (branch == "nodout") return row.has_columns({"x_displacement", "y_displacement", "z_displacement"}, count);
  return row.has_columns({"surfa", "surfb"}, count) || row.has_columns({"slave", "master"}, count);
}

/// "/glstat/d000001" is a state of the branch glstat, "/glstat/metadata" is for all of them.
struct BinoutPlace {
  std::string branch;
  bool metadata = false, state = false;
};

BinoutPlace place_of(std::string_view path) {
  const std::size_t slash = path.find('/', 1);
  if (!path.starts_with('/') || slash == std::string_view::npos) return {};
  const std::string_view last = path.substr(slash + 1);
  return {std::string(path.substr(1, slash - 1)), last == "metadata",
          last.starts_with('d') && last.find('/') == std::string_view::npos && last.size() > 1 &&
              last.find_first_not_of("0123456789", 1) == std::string_view::npos};
}

/// Collects the states of one file.
class BinoutCollector {
 public:
  BinoutCollector(RunResults& run, std::vector<std::string> wanted) : run_(run), wanted_(std::move(wanted)) {}

  void take(const LsdaArray& array) {
    if (array.path() != path_) {
      finish();
      path_ = array.path();
      place_ = place_of(path_);
      chosen_ = std::find(wanted_.begin(), wanted_.end(), place_.branch) != wanted_.end();
    }
    if (!chosen_) return;
    if (place_.metadata) add_metadata(meta_[place_.branch], array);
    if (place_.state) row_.add(array);
  }

  /// The last state.
  void finish() {
    if (!row_.empty()) take_state(meta_[place_.branch]);
    row_.clear();
  }

  [[nodiscard]] std::size_t left_out() const { return left_out_; }

 private:
  static void add_metadata(BinoutMeta& meta, const LsdaArray& array) {
    meta.row.add(array);
    if (array.name() == "ids") meta.ids = meta.row.integers("ids");
    if (array.name() == "side") meta.sides = meta.row.integers("side");
  }

  void take_state(const BinoutMeta& meta) {
    if (!is_complete(place_.branch, meta, row_)) {
      ++left_out_;
      return;
    }
    if (place_.branch == "glstat") run_.glstat.push_back(global_state(row_));
    if (place_.branch == "rcforc") run_.rcforc.states.push_back(contact_forces(meta, row_));
    if (place_.branch == "sleout") run_.sleout.states.push_back(contact_energies(meta, row_));
    if (place_.branch == "matsum") run_.matsum.states.push_back(part_states(meta, row_));
    if (place_.branch == "nodout") run_.nodout.states.push_back(node_states(meta, row_));
  }

  RunResults& run_;
  std::vector<std::string> wanted_;
  std::string path_;
  BinoutPlace place_;
  bool chosen_ = false;
  std::map<std::string, BinoutMeta> meta_;
  BinoutRow row_;
  std::size_t left_out_ = 0;
};

/// binout, binout0000, …, sorted.
std::vector<std::string> binout_files(const std::string& directory) {
  namespace fs = std::filesystem;
  std::vector<std::string> names;
  std::error_code failed;
  for (fs::directory_iterator entry(directory.empty() ? "." : directory, failed), end; !failed && entry != end;
       entry.increment(failed)) {
    const std::string name = entry->path().filename().string();
    if (name.starts_with("binout") && name.find_first_not_of("0123456789", 6) == std::string::npos)
      names.push_back(entry->path().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

void read_binout(RunResults& run, bool nodes, Diagnostics& diagnostics) {
  std::vector<std::string> wanted = run.missing;
  if (!nodes) std::erase(wanted, "nodout");
  if (wanted.empty()) return;
  for (const std::string& path : binout_files(run.directory)) {
    const auto file = FileBytes::open(path);
    if (!file) {
      diagnostics.add(file.error());
      continue;
    }
    BinoutCollector collector(run, wanted);
    const Status read = read_lsda(
        file.value().bytes(), path, [&](const LsdaArray& array) { collector.take(array); }, diagnostics);
    if (!read.ok()) {
      diagnostics.warning(path, 0, read.error().message);
      continue;
    }
    collector.finish();
    if (collector.left_out() > 0)
      diagnostics.warning(
          path, 0,
          fmt::format("{} states without their time or the values of all ids are left out", collector.left_out()));
  }
  const auto found = [&](const std::string& name) {
    return (name == "glstat" && !run.glstat.empty()) || (name == "rcforc" && !run.rcforc.states.empty()) ||
           (name == "sleout" && !run.sleout.states.empty()) || (name == "matsum" && !run.matsum.states.empty()) ||
           (name == "nodout" && !run.nodout.states.empty());
  };
  std::erase_if(run.missing, found);
}

}  // namespace gapcheck::results
