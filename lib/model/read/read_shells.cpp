#include <algorithm>
#include <map>
#include <utility>

#include "model/read/cards.hpp"
#include "model/read/elements.hpp"
#include "model/read/plies.hpp"

namespace gapcheck::model {
namespace {

constexpr ElementTraits shell{"shell", 3};

/// Rows of shells with the data of their extra lines.
struct ShellRows {
  ElementRows rows;
  std::vector<ShellThickness> thickness;  ///< `shell` counts rows
  std::vector<ShellOffset> offset;
  std::vector<ShellLayup> layup;
  std::vector<Layup> layups;
};

/// Elements share the layups that are the same.
class Layups {
 public:
  explicit Layups(std::vector<Layup>& list) : list_(list) {}
  std::uint32_t position(std::vector<Ply> plies, double thickness, Place place) {
    std::vector<std::pair<std::int64_t, double>> key;
    key.reserve(plies.size());
    for (const Ply& ply : plies) key.emplace_back(ply.material_id, ply.thickness);
    const auto [entry, is_new] = known_.try_emplace(std::move(key), static_cast<std::uint32_t>(list_.size()));
    if (is_new) list_.push_back({std::move(plies), thickness, place});
    return entry->second;
  }

 private:
  std::vector<Layup>& list_;
  std::map<std::vector<std::pair<std::int64_t, double>>, std::uint32_t> known_;
};

ShellRows read_with_extra_lines(Context& context, const Block& block, const Options& options) {
  static const CardLayout element = element_line(8), thickness = real_line(4, 16), offset = real_line(1, 16);
  const bool corners = options.any({"THICKNESS", "BETA", "MCID"});
  const bool plies = options.has("COMPOSITE");
  ShellRows shells;
  Layups layups(shells.layups);
  CardReader reader(context.deck, block, context.diagnostics);
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    const auto row = static_cast<std::uint32_t>(shells.rows.size());
    const Card card = reader.next(element);
    append_row(shells.rows, card, 4);
    ShellThickness own{row, {}};
    if (corners) {
      const Card values = reader.next(thickness);
      for (std::size_t i = 0; i < 4; ++i) own.thickness[i] = context.length(block, values.real(i));
      bool middle_nodes = false;
      for (std::size_t i = 6; i < 10; ++i) middle_nodes = middle_nodes || card.integer(i) != 0;
      if (middle_nodes) reader.skip();
    }
    if (options.has("OFFSET")) {
      const double value = context.length(block, reader.next(offset).real(0));
      if (value != 0) shells.offset.push_back({row, value});
    }
    if (options.has("DOF")) reader.skip();
    if (plies) {
      ElementPlies read = read_plies(reader, element, options.has("LONG"));
      const double sum = context.length(block, read.thickness);
      if (sum > 0) own.thickness.fill(sum);
      for (Ply& ply : read.plies) ply.thickness = context.length(block, ply.thickness);
      if (!read.plies.empty())
        shells.layup.push_back({row, layups.position(std::move(read.plies), sum, Context::place(block, card.line()))});
    }
    const auto given = [](double t) { return t != 0; };
    if (std::any_of(own.thickness.begin(), own.thickness.end(), given)) shells.thickness.push_back(own);
  }
  return shells;
}

/// Moves the data of rows to the shells made from them.
template <class Value>
void append_side_table(const std::vector<Value>& of_rows, const std::vector<std::uint32_t>& dropped,
                       std::uint32_t first, std::vector<Value>& of_shells) {
  std::size_t next = 0;
  for (Value value : of_rows) {
    while (next < dropped.size() && dropped[next] < value.shell) ++next;
    if (next < dropped.size() && dropped[next] == value.shell) continue;
    value.shell += first - static_cast<std::uint32_t>(next);
    of_shells.push_back(value);
  }
}

}  // namespace

void read_shells(Context& context, const Block& block, const Options& options) {
  Shells& shells = context.model.mesh.shells;
  if (!options.any({"THICKNESS", "BETA", "MCID", "OFFSET", "DOF", "COMPOSITE"})) {
    read_elements<4>(context, block, shell, shells);
    return;
  }
  const ShellRows read = read_with_extra_lines(context, block, options);
  const auto first = static_cast<std::uint32_t>(shells.size());
  const auto dropped = append_elements(context, block, shell, read.rows, static_cast<Elements<4>&>(shells));
  append_side_table(read.thickness, dropped, first, shells.own_thickness);
  append_side_table(read.offset, dropped, first, shells.own_offset);
  const auto before = static_cast<std::uint32_t>(shells.layups.size());
  const std::size_t table = shells.own_layup.size();
  append_side_table(read.layup, dropped, first, shells.own_layup);
  for (std::size_t i = table; i < shells.own_layup.size(); ++i) shells.own_layup[i].layup += before;
  shells.layups.insert(shells.layups.end(), read.layups.begin(), read.layups.end());
}

}  // namespace gapcheck::model
