#include "report/export/vtu.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "report/write/base64.hpp"
#include "report/write/xml_text.hpp"
#include "report/write/zlib_blocks.hpp"

namespace gapcheck::report {
namespace {

std::vector<float> single(std::span<const double> values, bool gaps = false) {
  constexpr double most = std::numeric_limits<float>::max();
  std::vector<float> list;
  list.reserve(values.size());
  for (const double value : values)
    list.push_back(std::isnan(value) ? (gaps ? std::numeric_limits<float>::quiet_NaN() : 0.0F)
                                     : static_cast<float>(std::clamp(value, -most, most)));
  return list;
}

/// The arrays of a file: their tags, and their data at its end, compressed and in base64.
class Arrays {
 public:
  /// The tag of an array whose data are added.
  template <class Value>
  std::string array(std::string_view type, std::string_view name, unsigned components,
                    const std::vector<Value>& values) {
    std::string tag = fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n", type,
        xml_text(name), components, data_.size());
    const ZlibBlocks blocks =
        zlib_blocks({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)});
    append_base64({reinterpret_cast<const char*>(blocks.header.data()), blocks.header.size() * sizeof(std::uint64_t)},
                  data_);
    append_base64(blocks.data, data_);
    return tag;
  }

  /// In 32 bits where all fit.
  std::string integers(std::string_view name, unsigned components, const std::vector<std::int64_t>& values) {
    using Short = std::numeric_limits<std::int32_t>;
    const auto is_short = [](std::int64_t value) { return value >= Short::min() && value <= Short::max(); };
    if (!std::all_of(values.begin(), values.end(), is_short)) return array("Int64", name, components, values);
    return array("Int32", name, components, std::vector<std::int32_t>(values.begin(), values.end()));
  }

  std::string fields(const std::vector<VtuArray>& list, const std::vector<VtuIds>& ids) {
    std::string tags;
    for (const VtuArray& data : list) {
      if (!data.whole) {
        tags += array("Float32", data.name, data.components, single(data.values, data.gaps));
        continue;
      }
      std::vector<std::int64_t> whole;
      whole.reserve(data.values.size());
      for (const double value : data.values)
        whole.push_back(std::abs(value) < 9e18 ? static_cast<std::int64_t>(value) : 0);
      tags += integers(data.name, data.components, whole);
    }
    for (const VtuIds& data : ids) tags += integers(data.name, 1, data.values);
    return tags;
  }

  [[nodiscard]] const std::string& data() const { return data_; }

 private:
  std::string data_;
};

/// These files contain strings as the numbers of their bytes, each string followed by a zero.
std::string field_data(const std::vector<VtuWords>& list) {
  if (list.empty()) return "";
  std::string text = "<FieldData>\n";
  for (const VtuWords& words : list) {
    text += fmt::format("<DataArray type=\"String\" Name=\"{}\" NumberOfTuples=\"{}\" format=\"ascii\">\n",
                        xml_text(words.name), words.values.size());
    for (const std::string& word : words.values) {
      for (const char c : plain_text(word)) text += fmt::format("{} ", static_cast<unsigned char>(c));
      text += "0\n";
    }
    text += "</DataArray>\n";
  }
  return text + "</FieldData>\n";
}

}  // namespace

std::string vtu_begin(std::string_view type, bool compressed) {
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"{0}\" version=\"1.0\" byte_order=\"{1}\" "
      "header_type=\"UInt64\"{2}>\n<{0}>\n",
      type, std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian",
      compressed ? " compressor=\"vtkZLibDataCompressor\"" : "");
}

void VtuGrid::add_cell(std::span<const std::uint32_t> nodes) {
  std::size_t corners = nodes.size();
  VtuCell type = corners == 1 ? VtuCell::vertex : VtuCell::line;
  if (corners == 8) {
    const bool four = std::all_of(nodes.begin() + 4, nodes.end(), [&](std::uint32_t node) { return node == nodes[3]; });
    type = four ? VtuCell::tetrahedron : VtuCell::hexahedron;
    if (four) corners = 4;
  } else if (corners == 4) {
    type = nodes[2] == nodes[3] ? VtuCell::triangle : VtuCell::quad;
    if (type == VtuCell::triangle) corners = 3;
  }
  connectivity.insert(connectivity.end(), nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(corners));
  offsets.push_back(connectivity.size());
  types.push_back(type);
}

std::string vtu(const VtuGrid& grid) {
  std::vector<double> points;
  for (const auto& point : grid.points) points.insert(points.end(), point.begin(), point.end());
  std::vector<std::int64_t> offsets(grid.offsets.begin(), grid.offsets.end());
  std::vector<std::int64_t> connectivity(grid.connectivity.begin(), grid.connectivity.end());
  std::vector<std::uint8_t> types;
  for (const VtuCell type : grid.types) types.push_back(static_cast<std::uint8_t>(type));
  Arrays arrays;
  std::string text = vtu_begin("UnstructuredGrid", true) + field_data(grid.words);
  text += fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", grid.points.size(), grid.types.size());
  text += "<Points>\n" + arrays.array("Float32", "Points", 3, single(points)) + "</Points>\n";
  // One statement per tag: the operands of + are evaluated in any order, and the data follow that of the calls.
  text += "<Cells>\n";
  text += arrays.integers("connectivity", 1, connectivity);
  text += arrays.integers("offsets", 1, offsets);
  text += arrays.array("UInt8", "types", 1, types);
  text += "</Cells>\n<PointData>\n";
  text += arrays.fields(grid.point_data, grid.point_ids);
  text += "</PointData>\n<CellData>\n";
  text += arrays.fields(grid.cell_data, grid.cell_ids);
  text += "</CellData>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"base64\">\n_";
  text += arrays.data();
  return text + "\n</AppendedData>\n</VTKFile>\n";
}

std::string pvd(std::span<const PvdEntry> entries) {
  std::string text = vtu_begin("Collection", false);
  for (const PvdEntry& entry : entries)
    text += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", entry.time, xml_text(entry.file));
  return text + "</Collection>\n</VTKFile>\n";
}

}  // namespace gapcheck::report
