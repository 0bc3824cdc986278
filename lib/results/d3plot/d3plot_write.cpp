#include "results/d3plot/d3plot_write.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "results/d3plot/d3plot_buffer.hpp"
#include "results/d3plot/d3plot_header.hpp"
#include "results/d3plot/d3plot_words.hpp"
#include "results/d3plot/run_folder.hpp"

namespace gapcheck::results {
namespace {

constexpr std::uint64_t block_words = D3plotWords::block_words;
constexpr std::int64_t solid_values = 7, shell_values = 7 * D3plotState::surfaces + 8 + 4;
constexpr std::int64_t thick_shell_values = 7 * D3plotState::surfaces;
constexpr std::int64_t global_values = 6, part_values = 7;
/// MAXINT is -(this + layers) if states end in a table of the existing elements (MDLOPT = 2).
constexpr std::int64_t element_deletion = 10000;
constexpr std::int64_t part_titles = 90001;
constexpr std::size_t part_title_bytes = 72;

Diagnostic failure(const std::string& path, std::string problem) {
  return {Severity::error, path, 0, std::move(problem)};
}

std::int64_t count(std::size_t size) { return static_cast<std::int64_t>(size); }

/// Writes the sections before the states.
class GeometryWriter {
 public:
  GeometryWriter(const D3plot& mesh, const std::vector<LegendEntry>& parts, const D3plotWriteSettings& settings)
      : mesh_(mesh),
        parts_(parts),
        word_bytes_(settings.word_bytes),
        deletion_(settings.deletion),
        out_(settings.word_bytes) {
    for (std::size_t i = 0; i < parts.size(); ++i) number_.try_emplace(parts[i].id, count(i) + 1);
  }

  std::string_view write() {
    control();
    for (const auto& x : mesh_.coordinates) out_.reals(x);
    elements(mesh_.solids, 0);
    elements(mesh_.thick_shells, 0);
    elements(mesh_.beams, 3);
    elements(mesh_.shells, 0);
    numbering();
    titles();
    out_.pad(block_words);
    return out_.bytes();
  }

  /// Of each solid, thick shell, shell and beam.
  [[nodiscard]] std::vector<std::int64_t> part_numbers() const {
    std::vector<std::int64_t> numbers;
    for (const auto* list : {&mesh_.solids.parts, &mesh_.thick_shells.parts, &mesh_.shells.parts, &mesh_.beams.parts})
      for (const std::int64_t part : *list) numbers.push_back(number_.at(part));
    return numbers;
  }

 private:
  void control() {
    out_.text(mesh_.title, control_words::title_words * static_cast<std::size_t>(word_bytes_));
    std::array<std::int64_t, D3plotHeader::words> words{};
    words[control_words::file_type] = 1;
    words[control_words::ndim] = 4;
    words[control_words::numnp] = count(mesh_.node_ids.size());
    words[control_words::icode] = 6;
    words[control_words::nglbv] = global_values + part_values * count(parts_.size());
    words[control_words::iu] = words[control_words::iv] = 1;
    words[control_words::nel8] = count(mesh_.solids.ids.size());
    words[control_words::nv3d] = solid_values;
    words[control_words::nel2] = count(mesh_.beams.ids.size());
    words[control_words::nv1d] = D3plotState::beam_values;
    words[control_words::nel4] = count(mesh_.shells.ids.size());
    words[control_words::nv2d] = shell_values;
    const std::int64_t layers = D3plotState::surfaces;
    words[control_words::maxint] = deletion_ ? -(element_deletion + layers) : layers;
    words[control_words::narbs] = numbering_words();
    words[control_words::nelt] = count(mesh_.thick_shells.ids.size());
    words[control_words::nv3dt] = thick_shell_values;
    // Stress, plastic strain, resultants, thickness and energies of shells are present.
    for (std::size_t i = 0; i < 4; ++i) words[control_words::ioshl + i] = 1000;
    count_materials(words);
    words[control_words::nmmat] = count(parts_.size());
    for (std::size_t i = control_words::title_words; i < words.size(); ++i) {
      if (i == control_words::release)
        out_.text(d3plot_mark, static_cast<std::size_t>(word_bytes_));
      else
        out_.integer(words[i]);
    }
  }

  /// Parts by their elements; the sum over the kinds is the number of parts.
  void count_materials(std::array<std::int64_t, D3plotHeader::words>& words) const {
    std::vector<std::size_t> kind(parts_.size(), control_words::nummat4);
    const auto mark = [&](const auto& elements, std::size_t word) {
      for (const std::int64_t part : elements.parts) kind[static_cast<std::size_t>(number_.at(part) - 1)] = word;
    };
    mark(mesh_.solids, control_words::nummat8);
    mark(mesh_.beams, control_words::nummat2);
    mark(mesh_.thick_shells, control_words::nummatt);
    for (const std::size_t word : kind) ++words[word];
  }

  [[nodiscard]] std::int64_t numbering_words() const {
    return 16 + count(mesh_.node_ids.size() + mesh_.solids.ids.size() + mesh_.thick_shells.ids.size() +
                      mesh_.beams.ids.size() + mesh_.shells.ids.size() + 3 * parts_.size());
  }

  template <std::size_t N>
  void elements(const D3plot::Elements<N>& elements, std::uint64_t unused) {
    for (std::size_t i = 0; i < elements.ids.size(); ++i) {
      for (const std::uint32_t node : elements.nodes[i]) out_.integer(std::int64_t{node} + 1);
      out_.zeros(unused);
      out_.integer(number_.at(elements.parts[i]));
    }
  }

  void ids(const std::vector<std::int64_t>& values) {
    for (const std::int64_t id : values) out_.integer(id);
  }

  /// Positions and lengths of the lists, then the lists: nodes, solids, beams, shells, thick shells, and the parts' ids
  /// in numbering order, sorted, and the positions of the sorted ones.
  void numbering() {
    const std::array<std::int64_t, 5> lengths{count(mesh_.node_ids.size()), count(mesh_.solids.ids.size()),
                                              count(mesh_.beams.ids.size()), count(mesh_.shells.ids.size()),
                                              count(mesh_.thick_shells.ids.size())};
    std::int64_t place = 1;
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      out_.integer(i == 0 ? -place : place);
      place += lengths[i];
    }
    for (const std::int64_t length : lengths) out_.integer(length);
    const std::int64_t parts = count(parts_.size());
    out_.integers({place, place + parts, place + 2 * parts, parts, 0, parts});
    ids(mesh_.node_ids);
    ids(mesh_.solids.ids);
    ids(mesh_.beams.ids);
    ids(mesh_.shells.ids);
    ids(mesh_.thick_shells.ids);
    for (const LegendEntry& part : parts_) out_.integer(part.id);
    for (const auto& [id, number] : number_) out_.integer(id);
    for (const auto& [id, number] : number_) out_.integer(number);
  }

  void titles() {
    out_.real(d3plot_end);
    out_.integers({part_titles, count(parts_.size())});
    for (const LegendEntry& part : parts_) {
      out_.integer(part.id);
      out_.text(column_text(part.title, part_title_bytes), part_title_bytes);
    }
    out_.real(d3plot_end);
  }

  const D3plot& mesh_;
  const std::vector<LegendEntry>& parts_;
  int word_bytes_;
  bool deletion_;
  std::map<std::int64_t, std::int64_t> number_;  ///< of a part's id, from 1
  WordBuffer out_;
};

template <class Elements>
bool all_parts_known(const Elements& elements, const std::vector<std::int64_t>& sorted_parts) {
  return std::all_of(elements.parts.begin(), elements.parts.end(), [&](std::int64_t part) {
    return std::binary_search(sorted_parts.begin(), sorted_parts.end(), part);
  });
}

/// What the caller must ensure, or the file could not be read again.
Status check(const std::string& path, const D3plot& mesh, const std::vector<LegendEntry>& parts) {
  if (mesh.node_ids.empty()) return failure(path, "a d3plot needs nodes");
  std::vector<std::int64_t> ids;
  ids.reserve(parts.size());
  for (const LegendEntry& part : parts) ids.push_back(part.id);
  std::sort(ids.begin(), ids.end());
  if (std::adjacent_find(ids.begin(), ids.end()) != ids.end()) return failure(path, "two parts have the same id");
  if (!all_parts_known(mesh.solids, ids) || !all_parts_known(mesh.thick_shells, ids) ||
      !all_parts_known(mesh.beams, ids) || !all_parts_known(mesh.shells, ids))
    return failure(path, "an element is in no part");
  return {};
}

bool needs_wide_words(const D3plot& mesh, const std::vector<LegendEntry>& parts) {
  const auto wide = [](std::int64_t id) { return id != static_cast<std::int32_t>(id); };
  const auto any = [&](const std::vector<std::int64_t>& ids) { return std::any_of(ids.begin(), ids.end(), wide); };
  return any(mesh.node_ids) || any(mesh.solids.ids) || any(mesh.thick_shells.ids) || any(mesh.beams.ids) ||
         any(mesh.shells.ids) ||
         std::any_of(parts.begin(), parts.end(), [&](const LegendEntry& part) { return wide(part.id); });
}

}  // namespace

Result<D3plotWriter> D3plotWriter::create(const std::string& path, const D3plot& mesh,
                                          const std::vector<LegendEntry>& parts, const D3plotWriteSettings& settings) {
  if (const Status status = check(path, mesh, parts); !status.ok()) return status.error();
  D3plotWriter writer;
  writer.settings_ = settings;
  writer.settings_.word_bytes = settings.word_bytes == 8 || needs_wide_words(mesh, parts) ? 8 : 4;
  writer.nodes_ = mesh.node_ids.size();
  writer.solids_ = mesh.solids.ids.size();
  writer.thick_shells_ = mesh.thick_shells.ids.size();
  writer.beams_ = mesh.beams.ids.size();
  writer.shells_ = mesh.shells.ids.size();
  writer.parts_ = parts.size();
  GeometryWriter geometry(mesh, parts, writer.settings_);
  if (settings.deletion) writer.part_numbers_ = geometry.part_numbers();
  auto family = D3plotFamily::create(path, geometry.write(), writer.settings_.word_bytes, settings.member_words);
  if (!family) return family.error();
  writer.family_ = std::move(family).value();
  return {std::move(writer)};
}

Status D3plotWriter::append(const D3plotState& state) {
  if (state.parts.size() != parts_ || state.coordinates.size() != nodes_ || state.velocities.size() != nodes_ ||
      state.solids.size() != solids_ || state.shells.size() != shells_ || state.beams.size() != beams_ ||
      state.layers != D3plotState::surfaces || state.shell_points.size() != shells_ * D3plotState::surfaces)
    return failure(family_.path(), "a state does not have the sizes of the mesh");
  const auto fits = [&](const std::vector<bool>& deleted, std::size_t size) {
    return deleted.empty() || (settings_.deletion && deleted.size() == size);
  };
  if (!fits(state.deleted_solids, solids_) || !fits(state.deleted_shells, shells_) ||
      !fits(state.deleted_beams, beams_))
    return failure(family_.path(), "elements are deleted in a database that does not say which");
  WordBuffer out(settings_.word_bytes);
  out.reals(std::array{state.time, state.kinetic, state.internal, state.total});
  out.reals(state.velocity);
  for (const PartValues& part : state.parts) out.real(part.internal);
  for (const PartValues& part : state.parts) out.real(part.kinetic);
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const PartValues& part : state.parts) out.real(part.velocity[axis]);
  for (const PartValues& part : state.parts) out.real(part.mass);
  for (const PartValues& part : state.parts) out.real(part.hourglass);
  for (const auto& x : state.coordinates) out.reals(x);
  for (const auto& v : state.velocities) out.reals(v);
  const auto point = [&](const StressPoint& values) {
    out.reals(values.stress);
    out.real(values.plastic_strain);
  };
  for (const StressPoint& solid : state.solids) point(solid);
  if (state.thick_shell_points.size() == thick_shells_ * D3plotState::surfaces)
    for (const StressPoint& layer : state.thick_shell_points) point(layer);
  else
    out.zeros(thick_shells_ * static_cast<std::uint64_t>(thick_shell_values));
  for (const auto& beam : state.beams) out.reals(beam);
  for (std::size_t i = 0; i < shells_; ++i) {
    for (std::size_t k = 0; k < D3plotState::surfaces; ++k) point(state.shell_points[i * D3plotState::surfaces + k]);
    out.reals(state.shells[i].resultants);
    out.reals(std::array{state.shells[i].thickness, 0.0, 0.0, state.shells[i].internal_energy});
  }
  const auto gone = [](const std::vector<bool>& deleted, std::size_t i) { return i < deleted.size() && deleted[i]; };
  for (std::size_t i = 0; i < part_numbers_.size(); ++i) {
    const std::size_t shell = i - solids_ - thick_shells_, beam = shell - shells_;  // wrap for others
    const bool deleted = i < solids_ ? gone(state.deleted_solids, i)
                                     : gone(state.deleted_shells, shell) || gone(state.deleted_beams, beam);
    out.real(deleted ? 0 : static_cast<double>(part_numbers_[i]));
  }
  return family_.append(std::move(out));
}

}  // namespace gapcheck::results
