#include "results/d3plot/d3plot_states.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include "results/d3plot/d3plot_header.hpp"
#include "results/d3plot/d3plot_words.hpp"

namespace gapcheck::results {
namespace {

using control_words::Place;

constexpr std::int64_t most_values = 1'000'000;  ///< per node, element or state
constexpr std::uint64_t point_values = 7;        ///< six stresses and a plastic strain
constexpr std::int64_t rigid_material = 20;
/// Kinds of titles after the geometry.
constexpr std::int64_t first_titles = 90000, last_titles = 90100;

/// The words of one file.
class FileWords {
 public:
  FileWords(std::string_view bytes, WordForm form) : bytes_(bytes), form_(form) {}
  [[nodiscard]] std::uint64_t size() const { return bytes_.size() / form_.bytes; }
  [[nodiscard]] double real(std::uint64_t at) const { return words::real(bytes_.data() + at * form_.bytes, form_); }
  [[nodiscard]] std::int64_t integer(std::uint64_t at) const {
    return words::integer(bytes_.data() + at * form_.bytes, form_);
  }
  [[nodiscard]] bool is_end(std::uint64_t at) const { return at < size() && real(at) == d3plot_end; }

 private:
  std::string_view bytes_;
  WordForm form_;
};

/// Derives a state's layout from the control words. `problem`: why there is none.
class LayoutReader {
 public:
  LayoutReader(const FileWords& words, const D3plot& mesh, D3plotStateLayout& layout, std::string& problem)
      : words_(words), mesh_(mesh), layout_(layout), problem_(problem) {}

  bool read() {
    if (word(Place::nmsph) > 0 || word(Place::npefg) > 0 || word(Place::ialemat) > 0 || word(Place::ndim) > 5)
      return fail("has particles, fluids, airbags or rigid surfaces; states with these are not read");
    layout_.dimensions = word(Place::ndim) == 2 ? 2 : 3;
    layout_.globals = width(Place::nglbv);
    layout_.parts = width(Place::nmmat);
    const std::uint64_t thermal_solid = word(Place::extra) > 1 ? width(D3plotHeader::words + 1) : 0;
    const std::uint64_t solid = width(Place::nv3d), thick_shell = width(Place::nv3dt), beam = width(Place::nv1d),
                        shell = width(Place::nv2d);
    if (!problem_.empty()) return false;
    add_nodes();
    take(mesh_.solids.ids.size() * thermal_solid);
    layout_.solids = mesh_.solids.ids.empty() || solid < point_values ? 0 : position_;
    layout_.solid_words = solid;
    take(mesh_.solids.ids.size() * solid);
    take(mesh_.thick_shells.ids.size() * thick_shell);
    layout_.beams = mesh_.beams.ids.empty() || beam < D3plotState::beam_values ? 0 : position_;
    layout_.beam_words = beam;
    take(mesh_.beams.ids.size() * beam);
    if (!find_shells()) return false;
    set_layers(shell);
    layout_.shells = layout_.shells_with_values.empty() || shell == 0 ? 0 : position_;
    layout_.shell_words = shell;
    take(layout_.shells_with_values.size() * shell);
    add_deletion_table();
    layout_.words = position_;
    return true;
  }

 private:
  bool fail(std::string problem) {
    if (problem_.empty()) problem_ = std::move(problem);
    return false;
  }
  [[nodiscard]] std::int64_t word(std::size_t at) const { return at < words_.size() ? words_.integer(at) : 0; }
  void take(std::uint64_t words) { position_ += words; }

  /// A plausible number of values.
  std::uint64_t width(std::size_t at) {
    const std::int64_t value = word(at);
    if (value >= 0 && value <= most_values) return static_cast<std::uint64_t>(value);
    fail(fmt::format("damaged: control word {} is {}", at, value));
    return 0;
  }

  /// Coordinates come first; then temperatures, fluxes and added mass as IT has them, velocities, accelerations.
  void add_nodes() {
    const std::uint64_t nodes = mesh_.node_ids.size(), vector = nodes * layout_.dimensions;
    take(1 + layout_.globals);
    if (word(Place::iu) == 1) {
      layout_.coordinates = position_;
      take(vector);
    }
    const std::int64_t it = word(Place::it);
    if (it % 10 == 1) take(nodes);
    if (it % 10 == 2) take(4 * nodes);
    if (it % 10 == 3) take(6 * nodes);
    if (it / 10 % 10 == 1) take(nodes);
    if (word(Place::iv) == 1) {
      layout_.velocities = position_;
      take(vector);
    }
    if (word(Place::ia) == 1) take(vector);
    const std::int64_t rates = word(Place::idtdt);
    if (rates % 10 == 1) take(nodes);
    if (rates / 10 % 10 == 1) take(6 * nodes);
  }

  /// With material types (NDIM = 5) rigid shells have no values.
  bool find_shells() {
    std::vector<std::uint32_t>& list = layout_.shells_with_values;
    list.resize(mesh_.shells.ids.size());
    std::iota(list.begin(), list.end(), 0u);
    if (word(Place::ndim) != 5) return true;
    const std::uint64_t start =
        D3plotHeader::words + static_cast<std::uint64_t>(std::max<std::int64_t>(0, word(Place::extra)));
    const std::int64_t rigid = word(start), types = word(start + 1);
    std::unordered_map<std::int64_t, std::int64_t> number_of;
    for (std::size_t i = 0; i < mesh_.part_ids.size(); ++i)
      number_of.emplace(mesh_.part_ids[i], static_cast<std::int64_t>(i) + 1);
    std::erase_if(list, [&](std::uint32_t shell) {
      const auto found = number_of.find(mesh_.shells.parts[shell]);
      const std::int64_t number = found == number_of.end() ? mesh_.shells.parts[shell] : found->second;
      return number >= 1 && number <= types && word(start + 1 + static_cast<std::uint64_t>(number)) == rigid_material;
    });
    if (static_cast<std::int64_t>(mesh_.shells.ids.size() - list.size()) == rigid) return true;
    return fail(fmt::format("damaged: it gives {} rigid shells, its material types {}", rigid,
                            mesh_.shells.ids.size() - list.size()));
  }

  void set_layers(std::uint64_t shell) {
    const auto given = [&](std::size_t flag) {
      return word(Place::ioshl + flag) == 1000 || word(Place::ioshl + flag) == 1;
    };
    std::int64_t layers = word(Place::maxint);
    if (layers < 0) layers = layers <= -10000 ? -(layers + 10000) : -layers;
    layers = std::clamp<std::int64_t>(layers, 0, most_values);
    const std::int64_t history = std::clamp<std::int64_t>(word(Place::neips), 0, most_values);
    layout_.layer_stress = given(0);
    layout_.layer_strain = given(1);
    layout_.layer_words = (given(0) ? 6u : 0u) + (given(1) ? 1u : 0u) + static_cast<std::uint64_t>(history);
    layout_.layers = static_cast<std::uint64_t>(layers);
    const std::uint64_t points = layout_.layers * layout_.layer_words, after = points + (given(2) ? 8u : 0u);
    if (points > shell || layout_.layer_words == 0) layout_.layers = 0;
    layout_.shell_resultants = given(2) && after <= shell;
    layout_.shell_thickness = given(3) && after + 4 <= shell;
  }

  void add_deletion_table() {
    const std::int64_t layers = word(Place::maxint);
    if (layers <= -10000) {
      layout_.deletion = position_;
      take(mesh_.solids.ids.size() + mesh_.thick_shells.ids.size() + mesh_.shells.ids.size() + mesh_.beams.ids.size());
    } else if (layers < 0) {
      take(mesh_.node_ids.size());
    }
  }

  const FileWords& words_;
  const D3plot& mesh_;
  D3plotStateLayout& layout_;
  std::string& problem_;
  std::uint64_t position_ = 0;
};

/// Where states may begin in the file of the geometry: after the geometry and its titles. They cannot be zeros.
std::uint64_t behind_titles(const FileWords& words, std::uint64_t at) {
  while (words.is_end(at)) {
    ++at;
    if (at >= words.size() || words.integer(at) < first_titles || words.integer(at) > last_titles) return at;
    while (at < words.size() && !words.is_end(at)) ++at;
  }
  return at;
}

bool all_zero(const FileWords& words, std::uint64_t begin, std::uint64_t end) {
  for (std::uint64_t at = begin; at < end; ++at)
    if (words.integer(at) != 0) return false;
  return true;
}

}  // namespace

Result<D3plotStates> D3plotStates::open(const std::string& path, DatabaseKind kind) {
  auto mesh = read_d3plot(path, kind);
  if (!mesh) return mesh.error();
  D3plotStates states;
  states.mesh_ = std::move(mesh).value();
  auto file = FileBytes::open(path);
  if (!file) return file.error();
  states.files_.push_back(std::move(file).value());
  const std::string_view bytes = states.files_[0].bytes();
  const auto header = read_d3plot_header(bytes);
  if (!header) return Diagnostic{Severity::error, path, 0, "has changed while it was read"};
  states.word_bytes_ = header->form.bytes;
  states.swapped_ = header->form.swapped;
  const FileWords words(bytes, header->form);
  std::string problem;
  if (!LayoutReader(words, states.mesh_, states.layout_, problem).read())
    return Diagnostic{Severity::error, path, 0, problem};
  // The geometry itself may continue in further files, which then also hold the states after it.
  std::uint64_t start = states.mesh_.geometry_words;
  for (std::uint32_t member = 0;; ++member) {
    if (member > 0) {
      auto next = FileBytes::open(fmt::format("{}{:02}", path, member));
      if (!next) break;
      states.files_.push_back(std::move(next).value());
    }
    const FileWords part(states.files_.back().bytes(), header->form);
    const bool geometry = member == 0 || start > 0;
    if (geometry && start > part.size()) {
      start -= part.size();
      continue;
    }
    if (geometry && states.mesh_.geometry_words == 0) continue;
    states.find_states(member, geometry ? behind_titles(part, start) : 0);
    start = 0;
  }
  return {std::move(states)};
}

void D3plotStates::find_states(std::uint32_t file, std::uint64_t word) {
  const FileWords words(files_[file].bytes(), {word_bytes_, swapped_});
  while (word < words.size() && !words.is_end(word)) {
    // What follows are zeros, or a state that is cut off.
    if (words.size() - word < layout_.words || all_zero(words, word, word + layout_.words)) return;
    places_.push_back({file, word});
    times_.push_back(words.real(word));
    word += layout_.words;
  }
}

D3plotState D3plotStates::read(std::size_t i) const {
  const FileWords words(files_[places_[i].file].bytes(), {word_bytes_, swapped_});
  const std::uint64_t start = places_[i].word;
  D3plotState state;
  state.time = times_[i];
  const auto global = [&](std::uint64_t at) { return at < layout_.globals ? words.real(start + 1 + at) : 0; };
  state.kinetic = global(0);
  state.internal = global(1);
  state.total = global(2);
  for (std::uint64_t axis = 0; axis < 3; ++axis) state.velocity[axis] = global(3 + axis);
  const std::uint64_t parts = layout_.parts;
  if (layout_.globals >= 6 && (layout_.globals - 6) / 7 >= parts) {
    state.parts.resize(parts);
    for (std::uint64_t part = 0; part < parts; ++part) {
      const auto value = [&](std::uint64_t row) { return global(6 + row * parts + part); };
      state.parts[part] = {value(0), value(1), value(5), value(6), {value(2), value(3), value(4)}};
    }
  }
  const auto vectors = [&](std::uint64_t offset, std::vector<std::array<double, 3>>& list) {
    if (offset == 0) return;
    list.resize(mesh_.node_ids.size());
    std::uint64_t at = start + offset;
    for (auto& v : list)
      for (unsigned axis = 0; axis < layout_.dimensions; ++axis) v[axis] = words.real(at++);
  };
  vectors(layout_.coordinates, state.coordinates);
  vectors(layout_.velocities, state.velocities);
  const auto point = [&](std::uint64_t at, bool stress, bool strain) {
    StressPoint p;
    if (stress)
      for (double& value : p.stress) value = words.real(at++);
    if (strain) p.plastic_strain = words.real(at);
    return p;
  };
  if (layout_.solids != 0)
    for (std::uint64_t k = 0; k < mesh_.solids.ids.size(); ++k)
      state.solids.push_back(point(start + layout_.solids + k * layout_.solid_words, true, true));
  if (layout_.beams != 0)
    for (std::uint64_t k = 0; k < mesh_.beams.ids.size(); ++k) {
      state.beams.emplace_back();
      for (std::uint64_t j = 0; j < D3plotState::beam_values; ++j)
        state.beams.back()[j] = words.real(start + layout_.beams + k * layout_.beam_words + j);
    }
  if (layout_.deletion != 0) {
    const auto deleted = [&](std::size_t from, std::size_t count, std::vector<bool>& list) {
      for (std::size_t k = 0; k < count; ++k) list.push_back(words.real(start + layout_.deletion + from + k) == 0);
    };
    const std::size_t solids = mesh_.solids.ids.size();
    deleted(0, solids, state.deleted_solids);
    const std::size_t shells = solids + mesh_.thick_shells.ids.size();
    deleted(shells, mesh_.shells.ids.size(), state.deleted_shells);
    deleted(shells + mesh_.shells.ids.size(), mesh_.beams.ids.size(), state.deleted_beams);
  }
  state.layers = std::min<std::size_t>(layout_.layers, D3plotState::surfaces);
  if (layout_.shells == 0) return state;
  state.shells.resize(mesh_.shells.ids.size());
  state.shell_points.resize(mesh_.shells.ids.size() * state.layers);
  std::uint64_t at = start + layout_.shells;
  for (const std::uint32_t shell : layout_.shells_with_values) {
    for (std::uint64_t k = 0; k < state.layers; ++k)
      state.shell_points[shell * state.layers + k] =
          point(at + k * layout_.layer_words, layout_.layer_stress, layout_.layer_strain);
    std::uint64_t behind = at + layout_.layers * layout_.layer_words;
    if (layout_.shell_resultants)
      for (double& value : state.shells[shell].resultants) value = words.real(behind++);
    if (layout_.shell_thickness) {
      state.shells[shell].thickness = words.real(behind);
      state.shells[shell].internal_energy = words.real(behind + 3);
    }
    at += layout_.shell_words;
  }
  return state;
}

std::vector<double> D3plotStates::shell_words(std::size_t i) const {
  const FileWords words(files_[places_[i].file].bytes(), {word_bytes_, swapped_});
  std::vector<double> values;
  if (layout_.shells == 0) return values;
  const std::uint64_t first = places_[i].word + layout_.shells;
  values.reserve(layout_.shells_with_values.size() * layout_.shell_words);
  for (std::uint64_t k = 0; k < layout_.shells_with_values.size() * layout_.shell_words; ++k)
    values.push_back(words.real(first + k));
  return values;
}

}  // namespace gapcheck::results
