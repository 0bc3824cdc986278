#include "report/export/vtu.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "report/write/base64.hpp"
#include "report/write/xml_text.hpp"

namespace gapcheck::report {
namespace {

/// Length in bytes followed by the bytes, encoded as one.
template <class Value>
std::string encoded(const std::vector<Value>& values) {
  const std::uint64_t length = values.size() * sizeof(Value);
  std::string bytes(sizeof length + length, '\0');
  std::memcpy(bytes.data(), &length, sizeof length);
  if (!values.empty()) std::memcpy(bytes.data() + sizeof length, values.data(), length);
  std::string text;
  append_base64(bytes, text);
  return text;
}

std::vector<float> single(std::span<const double> values, bool gaps = false) {
  constexpr double most = std::numeric_limits<float>::max();
  std::vector<float> list;
  list.reserve(values.size());
  for (const double value : values)
    list.push_back(std::isnan(value) ? (gaps ? std::numeric_limits<float>::quiet_NaN() : 0.0F)
                                     : static_cast<float>(std::clamp(value, -most, most)));
  return list;
}

template <class Value>
std::string array(std::string_view type, std::string_view name, unsigned components, const std::vector<Value>& values) {
  return fmt::format(
      "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">\n{}\n</DataArray>\n", type,
      xml_text(name), components, encoded(values));
}

/// In 32 bits where all fit.
std::string integers(std::string_view name, unsigned components, const std::vector<std::int64_t>& values) {
  using Short = std::numeric_limits<std::int32_t>;
  const auto is_short = [](std::int64_t value) { return value >= Short::min() && value <= Short::max(); };
  if (!std::all_of(values.begin(), values.end(), is_short)) return array("Int64", name, components, values);
  std::vector<std::int32_t> list;
  list.reserve(values.size());
  for (const std::int64_t value : values) list.push_back(static_cast<std::int32_t>(value));
  return array("Int32", name, components, list);
}

std::string data_arrays(const std::vector<VtuArray>& list, const std::vector<VtuIds>& ids) {
  std::string text;
  for (const VtuArray& data : list) {
    if (!data.whole) {
      text += array("Float32", data.name, data.components, single(data.values, data.gaps));
      continue;
    }
    std::vector<std::int64_t> whole;
    for (const double value : data.values)
      whole.push_back(std::abs(value) < 9e18 ? static_cast<std::int64_t>(value) : 0);
    text += integers(data.name, data.components, whole);
  }
  for (const VtuIds& data : ids) text += integers(data.name, 1, data.values);
  return text;
}

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

std::string vtu_begin(std::string_view type) {
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"{0}\" version=\"1.0\" byte_order=\"{1}\" "
      "header_type=\"UInt64\">\n<{0}>\n",
      type, std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian");
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
  std::string text = vtu_begin("UnstructuredGrid") + field_data(grid.words);
  text += fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", grid.points.size(), grid.types.size());
  text += "<Points>\n" + array("Float32", "Points", 3, single(points)) + "</Points>\n";
  text += "<Cells>\n" + integers("connectivity", 1, connectivity) + integers("offsets", 1, offsets) +
          array("UInt8", "types", 1, types) + "</Cells>\n";
  text += "<PointData>\n" + data_arrays(grid.point_data, grid.point_ids) + "</PointData>\n";
  text += "<CellData>\n" + data_arrays(grid.cell_data, grid.cell_ids) + "</CellData>\n";
  return text + "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

std::string pvd(std::span<const PvdEntry> entries) {
  std::string text = vtu_begin("Collection");
  for (const PvdEntry& entry : entries)
    text += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", entry.time, xml_text(entry.file));
  return text + "</Collection>\n</VTKFile>\n";
}

}  // namespace gapcheck::report
