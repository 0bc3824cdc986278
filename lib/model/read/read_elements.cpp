#include <fmt/format.h>

#include "keyword/rows.hpp"
#include "model/entity/erase.hpp"
#include "model/read/cards.hpp"
#include "model/read/elements.hpp"
#include "model/read/plies.hpp"

namespace gapcheck::model {
namespace {

/// Thick shells with `extra` lines after each.
ElementRows read_rows_with(Context& context, const Block& block, std::size_t extra) {
  static const CardLayout line = element_line(8);
  ElementRows rows;
  CardReader reader(context.deck, block, context.diagnostics);
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    append_row(rows, reader.next(line), 8);
    skip_lines(reader, static_cast<std::int64_t>(extra));
  }
  return rows;
}

/// Thick shells with their plies, whose thickness does not matter: the nodes define it.
ElementRows read_layered(Context& context, const Block& block, bool angle_line) {
  static const CardLayout line = element_line(8);
  ElementRows rows;
  CardReader reader(context.deck, block, context.diagnostics);
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    append_row(rows, reader.next(line), 8);
    if (angle_line) reader.skip();
    static_cast<void>(read_plies(reader, line, false));
  }
  return rows;
}

/// Beams as written, with the data besides the end nodes.
struct BeamRows {
  ElementRows rows;
  std::vector<BeamValues> values;
};

/// The axes of a release code 0 to 7 as bits: none, r, s, t, r and s, s and t, t and r, all.
std::uint8_t released_axes(std::int64_t code) {
  constexpr std::uint8_t axes[] = {0, 1, 2, 4, 3, 6, 5, 7};
  return code >= 0 && code < 8 ? axes[code] : 0;
}

/// A distance by its components in the block's units and axes.
Vector placed_length(const Context& context, const Block& block, const Card& card, std::size_t first) {
  const Vector written(card.real(first), card.real(first + 1), card.real(first + 2));
  const keyword::Transform& transform = context.transform(block);
  return transform.length_factor * (transform.places ? Vector(transform.matrix * written) : written);
}

BeamRows read_beam_rows(Context& context, const Block& block, const Options& options) {
  const CardLayout& layout = keyword::card_layout("ELEMENT_BEAM", "card1");
  const CardLayout& direction = keyword::card_layout("ELEMENT_BEAM_ORIENTATION", "card1.2");
  const CardLayout& offset = keyword::card_layout("ELEMENT_BEAM_OFFSET", "card2");
  const std::size_t before = options.count({"THICKNESS", "SECTION", "SCALAR", "SCALR", "PID"}),
                    behind = options.count({"WARPAGE", "ELBOW"});
  BeamRows beams{{2, {}, {}}, {}};
  CardReader reader(context.deck, block, context.diagnostics);
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    const Card card = reader.next(layout);
    append_row(beams.rows, card, 2);
    BeamValues& values = beams.values.emplace_back();
    if (const auto third = context.model.mesh.nodes.lookup.find(card.integer("n3"))) values.third = NodeIndex(*third);
    std::size_t release = 0;
    for (const std::string_view field : {"rt1", "rr1", "rt2", "rr2"})
      values.releases[release++] = released_axes(card.integer(field));
    values.global_releases = card.integer("local") == 1;
    skip_lines(reader, static_cast<std::int64_t>(before));
    if (options.has("OFFSET")) {
      const Card ends = reader.next(offset);
      values.offsets = {placed_length(context, block, ends, 0), placed_length(context, block, ends, 3)};
    }
    if (options.has("ORIENTATION")) {
      const Card vector = reader.next(direction);
      const Vector written(vector.real("vx"), vector.real("vy"), vector.real("vz"));
      const keyword::Transform& transform = context.transform(block);
      values.orientation = transform.places ? Vector(transform.matrix * written) : written;
    }
    skip_lines(reader, static_cast<std::int64_t>(behind));
  }
  return beams;
}

/// Appends point masses to the existing ones; rows have one node each.
void append_masses(Context& context, const Block& block, const ElementRows& rows, std::vector<double> values) {
  Mesh& mesh = context.model.mesh;
  const auto dropped = append_elements(context, block, {"mass", 1, false}, rows, mesh.masses);
  erase_column(dropped, values);
  mesh.mass_values.insert(mesh.mass_values.end(), values.begin(), values.end());
}

/// Finds repeated ids, reports and removes them. Returns the removed positions.
template <std::size_t N, class... Columns>
std::vector<std::uint32_t> finish_kind(Context& context, std::string_view what, Elements<N>& elements,
                                       Columns&... columns) {
  // Particles are called by their nodes.
  const IdKind kind = what == "SPH particle" ? IdKind::node : IdKind::element;
  const auto place = [&](std::uint32_t i) { return Place{elements.origins.file(i), elements.line[i]}; };
  std::vector<std::uint32_t> again = elements.lookup.build(elements.id);
  for (const std::uint32_t i : again)
    context.duplicate(what, elements.id[i], place(*elements.lookup.find(elements.id[i])), place(i), kind);
  if (again.empty()) return again;
  erase_positions(again, elements.origins, elements.id, elements.nodes, elements.part, elements.line, columns...);
  elements.lookup.build(elements.id);
  return again;
}

/// Side tables of shells follow when shells are removed.
template <class Value>
void follow(const std::vector<std::uint32_t>& erased, std::vector<Value>& table) {
  std::erase_if(table, [&](const Value& v) { return std::binary_search(erased.begin(), erased.end(), v.shell); });
  for (Value& value : table) value.shell = position_after(erased, value.shell);
}

template <std::size_t N>
void mark_parts(const Elements<N>& elements, std::vector<bool>& used) {
  PartIndex last = none<PartIndex>;
  for (const PartIndex part : elements.part) {
    if (part == last) continue;
    last = part;
    if (part != none<PartIndex>) used[part.value] = true;
  }
}

void check_part_references(Context& context) {
  const Mesh& mesh = context.model.mesh;
  std::vector<bool> used(context.model.parts.size());
  mark_parts(mesh.shells, used);
  mark_parts(mesh.solids, used);
  mark_parts(mesh.thick_shells, used);
  mark_parts(mesh.beams, used);
  mark_parts(mesh.discrete, used);
  mark_parts(mesh.particles, used);
  for (std::size_t i = 0; i < used.size(); ++i) {
    const Part& part = context.model.parts[i];
    if (!used[i]) continue;
    if (!part.section)
      context.unknown(fmt::format("part {} names section {}, which is not defined", part.id.value, part.section_id),
                      part.place);
    if (!part.material)
      context.unknown(fmt::format("part {} names material {}, which is not defined", part.id.value, part.material_id),
                      part.place);
  }
}

}  // namespace

void read_thick_shells(Context& context, const Block& block, const Options& options) {
  constexpr ElementTraits thick_shell{"thick shell", 6};
  auto& elements = context.model.mesh.thick_shells;
  const std::size_t extra = options.count({"BETA"});
  if (options.has("COMPOSITE"))
    append_elements(context, block, thick_shell, read_layered(context, block, extra > 0), elements);
  else if (extra > 0)
    append_elements(context, block, thick_shell, read_rows_with(context, block, extra), elements);
  else
    read_elements<8>(context, block, thick_shell, elements);
}

void read_beams(Context& context, const Block& block, const Options& options) {
  if (options.any({"THICKNESS", "SECTION"}))
    context.warning(Context::place(block, block.line),
                    fmt::format("*{}: the beams' own section data is not used; the part's section is", block.name));
  BeamRows beams = read_beam_rows(context, block, options);
  Mesh& mesh = context.model.mesh;
  const auto dropped = append_elements(context, block, {"beam", 2}, beams.rows, mesh.beams);
  erase_column(dropped, beams.values);
  mesh.beam_values.insert(mesh.beam_values.end(), beams.values.begin(), beams.values.end());
}

void read_discrete(Context& context, const Block& block, const Options& options) {
  const CardLayout& layout = keyword::card_layout("ELEMENT_DISCRETE", "card1");
  const double length = context.transform(block).length_factor;
  ElementRows rows{2, {}, {}};
  std::vector<DiscreteValues> values;
  CardReader reader(context.deck, block, context.diagnostics);
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    const Card card = reader.next(layout);
    append_row(rows, card, 2);
    const double scale = card.real("s");
    values.push_back(
        {card.integer("vid"), scale == 0 ? 1 : scale, length * card.real("offset"), card.integer("pf") != 1});
    if (options.has("LCO")) reader.skip();
  }
  Mesh& mesh = context.model.mesh;
  const auto dropped = append_elements(context, block, {"discrete element", 1}, rows, mesh.discrete);
  erase_column(dropped, values);
  mesh.discrete_values.insert(mesh.discrete_values.end(), values.begin(), values.end());
}

void read_masses(Context& context, const Block& block, const Options&) {
  const CardLayout& layout = keyword::card_layout("ELEMENT_MASS", "card1");
  const keyword::Rows read = keyword::read_rows(context.deck, block, layout, context.diagnostics);
  ElementRows rows{1, {}, read.lines};
  std::vector<double> values;
  const double factor = context.transform(block).mass_factor;
  for (std::size_t i = 0; i < read.count; ++i) {
    const std::int64_t* row = &read.integers[i * read.integer_columns];  // eid, nid, pid
    rows.values.insert(rows.values.end(), {row[0], row[2], row[1]});
    values.push_back(factor * read.reals[i * read.real_columns]);
  }
  append_masses(context, block, rows, std::move(values));
}

void read_inertias(Context& context, const Block& block, const Options& options) {
  const CardLayout& ids = keyword::card_layout("ELEMENT_INERTIA", "card1");
  const CardLayout& tensor = keyword::card_layout("ELEMENT_INERTIA", "card2");
  ElementRows rows{1, {}, {}};
  std::vector<double> values;
  CardReader reader(context.deck, block, context.diagnostics);
  while (!reader.at_end()) {
    if (skip_blank(reader)) continue;
    const Card card = reader.next(ids);
    rows.values.insert(rows.values.end(), {card.integer("eid"), 0, card.integer("nid")});
    rows.lines.push_back(card.line());
    values.push_back(context.transform(block).mass_factor * reader.next(tensor).real("mass"));
    if (options.has("OFFSET")) reader.skip();
  }
  append_masses(context, block, rows, std::move(values));
}

void read_particles(Context& context, const Block& block, const Options&) {
  const CardLayout& layout = keyword::card_layout("ELEMENT_SPH", "card1");
  const keyword::Rows read = keyword::read_rows(context.deck, block, layout, context.diagnostics);
  const IdLookup& nodes = context.model.mesh.nodes.lookup;
  ElementRows rows{1, {}, {}};
  const auto add = [&](std::int64_t node, std::int64_t part, std::uint32_t line) {
    rows.values.insert(rows.values.end(), {node, part, node});
    rows.lines.push_back(line);
  };
  // A hostile deck may name the same huge range in every line; particles beyond the number of nodes are repetitions.
  std::size_t budget = 2 * context.model.mesh.nodes.size() + read.count;
  for (std::size_t i = 0; i < read.count; ++i) {
    const std::int64_t* row = &read.integers[i * read.integer_columns];  // nid, pid, nend
    add(row[0], row[1], read.lines[i]);
    if (row[2] <= row[0]) continue;
    nodes.for_each_in(row[0] + 1, row[2], [&](std::int64_t node, std::uint32_t) {
      if (budget == 0) return false;
      --budget;
      add(node, row[1], read.lines[i]);
      return true;
    });
  }
  append_elements(context, block, {"SPH particle", 1}, rows, context.model.mesh.particles);
}

void finish_elements(Context& context) {
  Mesh& mesh = context.model.mesh;
  for (Layup& layup : mesh.shells.layups)
    for (Ply& ply : layup.plies)
      if (const auto found = context.material_of_id.find(ply.material_id); found != context.material_of_id.end())
        ply.material = found->second;
  const auto erased = finish_kind(context, "shell", static_cast<Elements<4>&>(mesh.shells));
  if (!erased.empty()) {
    follow(erased, mesh.shells.own_thickness);
    follow(erased, mesh.shells.own_offset);
    follow(erased, mesh.shells.own_layup);
  }
  finish_kind(context, "solid", mesh.solids);
  finish_kind(context, "thick shell", mesh.thick_shells);
  finish_kind(context, "beam", mesh.beams, mesh.beam_values);
  finish_kind(context, "discrete element", mesh.discrete, mesh.discrete_values);
  finish_kind(context, "mass", mesh.masses, mesh.mass_values);
  finish_kind(context, "SPH particle", mesh.particles);
  check_part_references(context);
}

}  // namespace gapcheck::model
