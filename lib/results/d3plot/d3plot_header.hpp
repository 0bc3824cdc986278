#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/number.hpp"
#include "results/d3plot/d3plot_words.hpp"

namespace gapcheck::results {

/// The counts of a d3plot's control words that the geometry depends on, as written; nothing is checked yet.
struct D3plotHeader {
  static constexpr std::uint64_t words = 64;
  WordForm form;
  std::string title;
  std::int64_t file_type = 0;  ///< 1: d3plot; + 1000: ids of 64 bits
  std::int64_t ndim = 0;       ///< dimensions, and above 3 which sections exist
  std::int64_t nodes = 0, solids = 0, beams = 0, shells = 0, thick_shells = 0, particles = 0;
  bool ten_node_solids = false;  ///< NEL8 was negative
  std::int64_t numbering_words = 0, materials = 0, sum_of_materials = 0;
  std::int64_t fluid_words = 0, airbags = 0, adapted = 0, extra_words = 0;
  bool reserved_words_used = false;

  [[nodiscard]] unsigned dimensions() const { return ndim == 2 ? 2 : 3; }
  [[nodiscard]] bool has_material_types() const { return ndim == 5 || ndim == 7; }
  [[nodiscard]] bool has_rigid_bodies() const { return ndim == 8 || ndim == 9; }
  [[nodiscard]] bool has_wide_ids() const { return file_type > wide_ids; }
  static constexpr std::int64_t wide_ids = 1000;
};

namespace control_words {

/// Positions of control words.
enum Place : std::size_t {
  title = 0,
  title_words = 10,
  file_type = 11,
  release = 13,
  ndim = 15,
  numnp = 16,
  icode = 17,
  nglbv = 18,
  it = 19,
  iu = 20,
  iv = 21,
  ia = 22,
  nel8 = 23,
  nummat8 = 24,
  nv3d = 27,
  nel2 = 28,
  nummat2 = 29,
  nv1d = 30,
  nel4 = 31,
  nummat4 = 32,
  nv2d = 33,
  neips = 35,
  maxint = 36,
  nmsph = 37,
  ngpsph = 38,
  narbs = 39,
  nelt = 40,
  nummatt = 41,
  nv3dt = 42,
  ioshl = 43,
  ialemat = 47,
  nadapt = 50,
  nmmat = 51,
  npefg = 54,
  idtdt = 56,
  extra = 57,
  first_reserved = 58,
};

/// A check that only the right word size and byte order are likely to pass. Counts are left to the reader, which can
/// say what is wrong with them.
inline bool plausible(std::string_view bytes, WordForm form) {
  if (bytes.size() < D3plotHeader::words * form.bytes) return false;
  const auto word = [&](std::size_t at) { return words::integer(bytes.data() + at * form.bytes, form); };
  const auto between = [](std::int64_t value, std::int64_t low, std::int64_t high) {
    return low <= value && value <= high;
  };
  return between(word(ndim), 2, 9) && between(word(icode), 0, 9) && between(word(file_type), 0, 1999);
}

/// The size of a count; the one negative number without a positive twin stays negative.
inline std::int64_t size_of(std::int64_t count) { return count < 0 && count > INT64_MIN ? -count : count; }

inline D3plotHeader decode(std::string_view bytes, WordForm form) {
  const auto word = [&](std::size_t at) { return words::integer(bytes.data() + at * form.bytes, form); };
  D3plotHeader header;
  header.form = form;
  const std::string_view text = bytes.substr(title, title_words * form.bytes);
  header.title = trimmed(text.substr(0, text.find('\0')));
  header.file_type = word(file_type);
  header.ndim = word(ndim);
  header.nodes = word(numnp);
  header.solids = size_of(word(nel8));
  header.ten_node_solids = word(nel8) < 0;
  header.beams = word(nel2);
  header.shells = word(nel4);
  header.thick_shells = word(nelt);
  header.particles = word(nmsph);
  header.numbering_words = word(narbs);
  header.materials = word(nmmat);
  for (const std::size_t at : {nummat8, nummat2, nummat4, nummatt, ngpsph}) {
    // A value larger than any file can hold replaces the sum, so nothing overflows.
    constexpr std::int64_t enough = std::int64_t{1} << 40;
    if (word(at) > 0 && word(at) < enough) header.sum_of_materials += word(at);
  }
  header.fluid_words = word(ialemat);
  header.airbags = word(npefg);
  header.adapted = word(nadapt);
  header.extra_words = word(extra);
  for (std::size_t at = first_reserved; at < D3plotHeader::words; ++at)
    if (word(at) != 0) header.reserved_words_used = true;
  return header;
}

}  // namespace control_words

/// Takes the word size and byte order under which the control words make sense; nothing if none does.
inline std::optional<D3plotHeader> read_d3plot_header(std::string_view bytes) {
  // Single precision first: pairs of its words can look like small numbers, halved words hardly ever do.
  for (const std::size_t size : {4, 8})
    for (const bool swapped : {false, true}) {
      const WordForm form{size, swapped};
      if (control_words::plausible(bytes, form)) return control_words::decode(bytes, form);
    }
  return std::nullopt;
}

}  // namespace gapcheck::results
