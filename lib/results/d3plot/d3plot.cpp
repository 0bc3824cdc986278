#include "results/d3plot/d3plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <system_error>
#include <utility>

#include "base/file_bytes.hpp"
#include "results/d3plot/d3plot_header.hpp"
#include "results/d3plot/d3plot_words.hpp"

namespace gapcheck::results {
namespace {

constexpr std::uint64_t beam_words = 6;  ///< both ends, three words for its orientation, part
constexpr std::size_t list_width = 2;    ///< words per entry of the lists after the numbering

/// Reads the sections before the states. The first fault ends it: `problem` says what.
class GeometryReader {
 public:
  GeometryReader(const D3plotHeader& header, D3plotWords& words, DatabaseKind kind)
      : header_(header), words_(words), kind_(kind) {}

  bool read(D3plot& plot) {
    plot.title = header_.title;
    plot.word_bytes = static_cast<int>(words_.form().bytes);
    return check_file_type() && pass_front() && locate() && read_numbering(plot) && read_coordinates(plot) &&
           read_elements(plot.solids, solids_, node_words_of(plot.solids), "solid", plot) &&
           read_elements(plot.thick_shells, thick_shells_, node_words_of(plot.thick_shells), "thick shell", plot) &&
           read_elements(plot.beams, beams_, beam_words, "beam", plot) &&
           read_elements(plot.shells, shells_, node_words_of(plot.shells), "shell", plot) && read_particles(plot);
  }
  [[nodiscard]] const std::string& problem() const { return problem_; }

 private:
  struct Section {
    std::uint64_t first = 0, count = 0;
  };

  bool fail(std::string problem) {
    problem_ = std::move(problem);
    return false;
  }

  template <std::size_t N>
  static std::uint64_t node_words_of(const D3plot::Elements<N>&) {
    return N + 1;
  }

  /// Moves past `count` entries; if it returns true all of them exist, so memory for them may be allocated.
  bool take(std::int64_t count, std::uint64_t width, std::string_view what, Section& section) {
    if (count < 0) return fail(fmt::format("damaged: its header gives {} {}", count, what));
    // Positions are kept in 32 bits.
    constexpr std::int64_t most = std::numeric_limits<std::uint32_t>::max() - 1;
    if (count > most || !words_.reach(position_ + static_cast<std::uint64_t>(count) * width))
      return fail(
          fmt::format("truncated or damaged: {} {} end beyond the last of {} words; take the whole file family "
                      "as the solver wrote it",
                      count, what, words_.size()));
    section = {position_, static_cast<std::uint64_t>(count)};
    position_ += section.count * width;
    return true;
  }
  bool pass(std::int64_t count, std::uint64_t width, std::string_view what) {
    Section section;
    return take(count, width, what, section);
  }
  /// Consumes one word and returns its value.
  bool next(std::string_view what, std::int64_t& value) {
    Section section;
    if (!take(1, 1, what, section)) return false;
    value = words_.integer(section.first);
    return true;
  }

  bool check_file_type() {
    const std::int64_t type = header_.file_type % D3plotHeader::wide_ids;
    if (kind_ == DatabaseKind::interface_forces)
      return type == 4 ||
             fail(fmt::format("is a database of type {}; one of interface forces has type 4", header_.file_type));
    switch (type) {
      case 0:   // older writers
      case 1:   // d3plot
      case 5:   // d3part
      case 11:  // d3eigv
        return true;
      default:
        return fail(fmt::format("is a database of type {} and no d3plot; give the run's d3plot", header_.file_type));
    }
  }

  /// The data between the control words and the coordinates.
  bool pass_front() {
    if (!pass(D3plotHeader::words, 1, "control words") || !pass(header_.extra_words, 1, "further control words"))
      return false;
    if (header_.has_material_types()) {
      std::int64_t rigid_elements = 0, materials = 0;
      if (!next("word of the material types", rigid_elements) || !next("word of the material types", materials) ||
          !pass(materials, 1, "material types"))
        return false;
    }
    return pass(header_.fluid_words, 1, "fluid materials") && pass_particle_flags() && pass_airbags();
  }

  bool pass_particle_flags() {
    if (header_.particles == 0) return true;
    std::int64_t length = 0;
    if (!next("word of the SPH flags", length)) return false;
    if (length < 1) return fail(fmt::format("damaged: it gives {} words of SPH flags", length));
    return pass(length - 1, 1, "SPH flags");
  }

  bool pass_airbags() {
    constexpr std::int64_t most_airbags = 10'000'000, version_unit = 1000, version_with_chambers = 4;
    constexpr std::uint64_t name_words = 8;
    if (header_.airbags <= 0 || header_.airbags > most_airbags) return true;
    std::int64_t geometry = 0, particle = 0, count = 0, state = 0;
    constexpr std::string_view what = "word of the airbag particles";
    if (!next(what, geometry) || !next(what, particle) || !next(what, count) || !next(what, state)) return false;
    if (header_.airbags / version_unit == version_with_chambers && !next(what, count)) return false;
    constexpr std::string_view variables = "airbag particle variables";
    return pass(geometry, 1 + name_words, variables) && pass(particle, 1 + name_words, variables) &&
           pass(state, 1 + name_words, variables);
  }

  /// Finds the sections from the coordinates to the numbering. The two extra nodes of ten-node solids are after the
  /// solids or at the end, and no control word says where; the numbering repeats the counts, which shows it.
  bool locate() {
    const std::uint64_t start = position_;
    if (!header_.ten_node_solids || header_.numbering_words == 0) return locate_with(header_.ten_node_solids);
    if (locate_with(true) && numbering_fits()) return true;
    position_ = start;
    return locate_with(false);
  }

  bool locate_with(bool extra_nodes_behind_solids) {
    return take(header_.nodes, header_.dimensions(), "nodes", nodes_) && take(header_.solids, 9, "solids", solids_) &&
           pass(extra_nodes_behind_solids ? header_.solids : 0, 2, "pairs of extra nodes") &&
           take(header_.thick_shells, 9, "thick shells", thick_shells_) &&
           take(header_.beams, beam_words, "beams", beams_) && take(header_.shells, 5, "shells", shells_);
  }

  /// True if a numbering section with the header's counts begins here.
  [[nodiscard]] bool numbering_fits() {
    if (header_.numbering_words < 10 || !words_.reach(position_ + 10)) return false;
    const std::int64_t counts[] = {header_.nodes, header_.solids, header_.beams, header_.shells, header_.thick_shells};
    for (std::uint64_t i = 0; i < 5; ++i)
      if (words_.integer(position_ + 5 + i) != counts[i]) return false;
    return true;
  }

  /// Ids of the user: nodes, elements, parts.
  bool read_numbering(D3plot& plot) {
    if (nodes_.count == 0) return fail("damaged: it has no nodes");
    if (header_.numbering_words == 0) {
      count_up(nodes_.count, plot.node_ids);
      count_up(solids_.count, plot.solids.ids);
      count_up(beams_.count, plot.beams.ids);
      count_up(shells_.count, plot.shells.ids);
      count_up(thick_shells_.count, plot.thick_shells.ids);
      return true;
    }
    const std::uint64_t start = position_;
    if (!pass(header_.numbering_words, 1, "words of numbering")) return false;
    const std::uint64_t end = std::exchange(position_, start);
    if (!numbering_fits())
      return fail(
          "damaged: the counts of the numbering are not those of the header (or elements are packed, as only "
          "very old versions wrote them)");
    position_ += words_.integer(start) < 0 ? 16 : 10;
    if (!take_ids(nodes_.count, plot.node_ids) || !take_ids(solids_.count, plot.solids.ids) ||
        !take_ids(beams_.count, plot.beams.ids) || !take_ids(shells_.count, plot.shells.ids) ||
        !take_ids(thick_shells_.count, plot.thick_shells.ids))
      return false;
    return take_part_ids(end) && check_node_ids(plot.node_ids);
  }

  /// The ids of the parts come three times: in the order of the elements' part numbers, sorted, and as positions. If
  /// the numbering ends before them, the numbers are the ids.
  bool take_part_ids(std::uint64_t end) {
    const std::uint64_t rest = end - std::min(position_, end);
    if (position_ > end || (rest > 0 && rest / 3 < material_count() * id_width()))
      return fail(fmt::format("damaged: {} words of numbering are too few for {} parts", header_.numbering_words,
                              material_count()));
    if (rest > 0 && !take_ids(material_count(), part_ids_)) return false;
    position_ = end;
    return true;
  }

  [[nodiscard]] std::uint64_t material_count() const {
    return static_cast<std::uint64_t>(
        std::max<std::int64_t>(0, header_.materials > 0 ? header_.materials : header_.sum_of_materials));
  }

  /// Ids of 64 bits take two words in single precision.
  [[nodiscard]] std::uint64_t id_width() const { return header_.has_wide_ids() && words_.form().bytes == 4 ? 2 : 1; }

  static void count_up(std::uint64_t count, std::vector<std::int64_t>& ids) {
    ids.resize(count);
    for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = static_cast<std::int64_t>(i) + 1;
  }

  bool take_ids(std::uint64_t count, std::vector<std::int64_t>& ids) {
    Section section;
    if (!take(static_cast<std::int64_t>(count), id_width(), "ids", section)) return false;
    ids.resize(section.count);
    for (std::uint64_t i = 0; i < section.count; ++i) ids[i] = id(section.first + i * id_width());
    return true;
  }

  [[nodiscard]] std::int64_t id(std::uint64_t at) const {
    if (id_width() == 1) return words_.integer(at);
    const bool high_first = words_.form().swapped != (std::endian::native == std::endian::big);
    const auto low = static_cast<std::uint32_t>(words_.integer(high_first ? at + 1 : at));
    return words_.integer(high_first ? at : at + 1) * (std::int64_t{1} << 32) + low;
  }

  bool check_node_ids(const std::vector<std::int64_t>& ids) {
    std::vector<std::int64_t> sorted;
    if (!std::is_sorted(ids.begin(), ids.end())) {
      sorted = ids;
      std::sort(sorted.begin(), sorted.end());
    }
    const std::vector<std::int64_t>& ascending = sorted.empty() ? ids : sorted;
    if (ascending.front() <= 0) return fail(fmt::format("damaged: a node has the id {}", ascending.front()));
    const auto again = std::adjacent_find(ascending.begin(), ascending.end());
    if (again != ascending.end()) return fail(fmt::format("damaged: two nodes have the id {}", *again));
    return true;
  }

  bool read_coordinates(D3plot& plot) {
    plot.coordinates.resize(nodes_.count);
    std::uint64_t at = nodes_.first;
    for (std::size_t i = 0; i < plot.coordinates.size(); ++i) {
      std::array<double, 3>& x = plot.coordinates[i];
      x = {};
      for (unsigned k = 0; k < header_.dimensions(); ++k) x[k] = words_.real(at++);
      if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
        return fail(fmt::format("damaged: a coordinate of node {} is not a number", plot.node_ids[i]));
    }
    return true;
  }

  /// Each element takes `width` words: the nodes first, its part last.
  template <std::size_t N>
  bool read_elements(D3plot::Elements<N>& elements, const Section& section, std::uint64_t width, std::string_view what,
                     const D3plot& plot) {
    elements.nodes.resize(section.count);
    elements.parts.resize(section.count);
    for (std::size_t i = 0; i < elements.nodes.size(); ++i) {
      const std::uint64_t at = section.first + i * width;
      if (!read_nodes(at, plot, elements.nodes[i]) || !read_part(at + width - 1, elements.parts[i]))
        return fail(fmt::format("damaged: {} {} {}", what, elements.ids[i], problem_));
    }
    return true;
  }

  template <std::size_t N>
  bool read_nodes(std::uint64_t at, const D3plot& plot, std::array<std::uint32_t, N>& nodes) {
    for (std::size_t k = 0; k < N; ++k) {
      const std::int64_t node = words_.integer(at + k);
      if (node == 0 && k > 0)
        nodes[k] = nodes[k - 1];
      else if (node <= 0 || static_cast<std::uint64_t>(node) > plot.node_ids.size())
        return fail(fmt::format("has node number {} of {}", node, plot.node_ids.size()));
      else
        nodes[k] = static_cast<std::uint32_t>(node - 1);
    }
    return true;
  }

  /// The id of the part whose number is at `at`.
  bool read_part(std::uint64_t at, std::int64_t& part) {
    const std::int64_t number = words_.integer(at);
    if (number <= 0 || (material_count() > 0 && static_cast<std::uint64_t>(number) > material_count()))
      return fail(fmt::format("has part number {} of {}", number, material_count()));
    part = part_ids_.empty() ? number : part_ids_[static_cast<std::size_t>(number - 1)];
    return true;
  }

  /// After the numbering: rigid bodies, parents of adapted elements, then the particles.
  bool read_particles(D3plot& plot) {
    const bool more = header_.has_rigid_bodies() || header_.adapted > 0 || header_.extra_words > 0 ||
                      header_.ten_node_solids || header_.particles > 0;
    if (!more) plot.geometry_words = position_;
    plot.part_ids = part_ids_;
    if (header_.particles == 0) return true;
    Section section;
    if (!pass_rigid_bodies() || !pass(header_.adapted, list_width, "adapted elements") ||
        !take(header_.particles, list_width, "SPH particles", section))
      return false;
    count_up(section.count, plot.particles.ids);
    if (!read_elements(plot.particles, section, list_width, "SPH particle", plot)) return false;
    for (std::size_t i = 0; i < plot.particles.ids.size(); ++i)
      plot.particles.ids[i] = plot.node_ids[plot.particles.nodes[i][0]];
    return true;
  }

  bool pass_rigid_bodies() {
    if (!header_.has_rigid_bodies()) return true;
    std::int64_t bodies = 0, value = 0, nodes = 0;
    if (!next("word of the rigid bodies", bodies)) return false;
    for (std::int64_t i = 0; i < bodies; ++i)
      if (!next("word of a rigid body", value) || !next("word of a rigid body", nodes) ||
          !pass(nodes, 1, "nodes of a rigid body") || !next("word of a rigid body", nodes) ||
          !pass(nodes, 1, "active nodes of a rigid body"))
        return false;
    return true;
  }

  const D3plotHeader& header_;
  D3plotWords& words_;
  DatabaseKind kind_;
  std::uint64_t position_ = 0;
  Section nodes_, solids_, thick_shells_, beams_, shells_;
  std::vector<std::int64_t> part_ids_;  ///< by part number - 1; empty: the numbers are the ids
  std::string problem_;
};

bool has_gzip_mark(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }

/// FEMZIP leaves the control words in place, but uses reserved words and replaces the count of materials; the zlib
/// streams begin soon after.
bool looks_like_femzip(std::string_view bytes, const D3plotHeader& header) {
  constexpr std::size_t front = 8192;
  if (!header.reserved_words_used && header.materials == header.sum_of_materials) return false;
  const std::string_view start = bytes.substr(0, front);
  // Method and window of a zlib stream, then one of its four check bytes.
  for (std::size_t at = 0; at + 1 < start.size(); ++at)
    if (start[at] == '\x78' && std::string_view("\x01\x5e\x9c\xda").find(start[at + 1]) != std::string_view::npos)
      return true;
  return false;
}

/// What the header and the marks of compressed files lie in.
constexpr std::size_t head_bytes = std::size_t{1} << 16;

/// `head`: the beginning of the file; `make_words`: all of it.
template <class MakeWords>
Result<D3plot> read(std::string_view head, const std::string& name, DatabaseKind kind, const MakeWords& make_words) {
  const auto failure = [&](std::string problem) { return Diagnostic{Severity::error, name, 0, std::move(problem)}; };
  if (head.empty()) return failure("is empty and no d3plot");
  if (has_gzip_mark(head)) return failure("is compressed (gzip); unpack it first");
  const auto header = read_d3plot_header(head);
  if (!header) return failure("is not a d3plot: no word size and byte order gives control words that make sense");
  D3plotWords words = make_words(header->form);
  GeometryReader reader(*header, words, kind);
  D3plot plot;
  if (reader.read(plot)) return plot;
  if (!words.status().ok()) return words.status().error();
  if (looks_like_femzip(head, *header)) return failure("is compressed (FEMZIP); unpack it with femunzip first");
  return failure(reader.problem());
}

}  // namespace

Result<D3plot> read_d3plot(const std::string& path, DatabaseKind kind) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    return Diagnostic{Severity::error, path, 0, "is a directory; give the d3plot file inside it"};
  auto file = FileBytes::begin(path);
  if (!file) return file.error();
  if (const Status head = file.value().load(head_bytes); !head.ok()) return head.error();
  return read(file.value().bytes(), path, kind,
              [&](WordForm form) { return D3plotWords(std::move(file).value(), path, form); });
}

Result<D3plot> read_d3plot_bytes(std::string_view bytes, const std::string& name) {
  return read(bytes, name, DatabaseKind::plot, [&](WordForm form) { return D3plotWords(bytes, form); });
}

}  // namespace gapcheck::results
