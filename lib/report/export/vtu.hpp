#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gapcheck::report {

/// Cells of an unstructured grid, as VTK numbers them.
enum class VtuCell : std::uint8_t { vertex = 1, line = 3, triangle = 5, quad = 9, tetrahedron = 10, hexahedron = 12 };

/// A named array of one, three or six numbers per point or cell.
struct VtuArray {
  std::string name;
  unsigned components = 1;
  std::vector<double> values = {};  ///< as many as there are points or cells times `components`
  bool whole = false;               ///< ids and the like: written as integers
  bool gaps = false;                ///< NaN stays NaN: "not known"
};

/// The same for integers that a double cannot hold.
struct VtuIds {
  std::string name;
  std::vector<std::int64_t> values;
};

/// Words that belong to the grid as a whole.
struct VtuWords {
  std::string name;
  std::vector<std::string> values;
};

/// An unstructured grid with its data.
struct VtuGrid {
  std::vector<std::array<double, 3>> points;
  std::vector<std::uint32_t> connectivity;  ///< positions of points, cell after cell
  std::vector<std::uint64_t> offsets;       ///< where each cell ends in it
  std::vector<VtuCell> types;
  std::vector<VtuArray> point_data, cell_data;
  std::vector<VtuIds> point_ids, cell_ids;
  std::vector<VtuWords> words;

  /// Adds a particle, beam, shell or solid of the solver: repeated corners at the end make a triangle or a tetrahedron;
  /// wedges and pyramids stay hexahedra with repeated corners.
  void add_cell(std::span<const std::uint32_t> nodes);
};

/// How a file of this type ("UnstructuredGrid", "Collection") begins here; other programs set other blanks.
[[nodiscard]] std::string vtu_begin(std::string_view type, bool compressed);

/// The grid as a .vtu file (VTK XML, version 1.0, appended data in base64, compressed by zlib): numbers in single
/// precision, ids and positions of points as 32-bit integers if a whole array fits, otherwise 64-bit. Numbers beyond
/// the range are clipped, NaN is 0. Control characters of words become '?'.
[[nodiscard]] std::string vtu(const VtuGrid& grid);

/// One file of a series.
struct PvdEntry {
  double time = 0;
  std::string file;
};

/// The collection (.pvd) that gives each file its time.
[[nodiscard]] std::string pvd(std::span<const PvdEntry> entries);

}  // namespace gapcheck::report
