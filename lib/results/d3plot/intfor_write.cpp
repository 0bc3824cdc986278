#include "results/d3plot/intfor_write.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/number.hpp"
#include "results/d3plot/d3plot_header.hpp"
#include "results/d3plot/d3plot_state.hpp"
#include "results/d3plot/run_folder.hpp"
#include "results/text/file_header.hpp"
#include "results/text/printed_number.hpp"

namespace gapcheck::results {
namespace {

constexpr std::int64_t interface_file_type = 4, surface_titles = 90001;
constexpr std::int64_t segment_values = 16, first_globals = 6, surface_globals = 7;
constexpr std::size_t surface_title_bytes = 72;

std::int64_t as_word(std::size_t count) { return static_cast<std::int64_t>(count); }

void put_control(const InterfaceMesh& mesh, int word_bytes, WordBuffer& out) {
  const auto bytes = static_cast<std::size_t>(word_bytes);
  out.text(mesh.title, control_words::title_words * bytes);
  const std::int64_t nodes = as_word(mesh.node_ids.size()), segments = as_word(mesh.segments.size()),
                     surfaces = as_word(mesh.surfaces.size());
  std::array<std::int64_t, D3plotHeader::words> words{};
  words[control_words::file_type] = interface_file_type;
  words[control_words::ndim] = 4;
  words[control_words::numnp] = nodes;
  words[control_words::icode] = 6;
  words[control_words::nglbv] = first_globals + surface_globals * surfaces;
  words[control_words::iu] = words[control_words::iv] = 1;
  words[control_words::nel4] = segments;
  words[control_words::nummat4] = words[control_words::nmmat] = surfaces;
  words[control_words::nv2d] = segment_values;
  words[control_words::narbs] = 16 + nodes + segments + 3 * surfaces;
  for (std::size_t i = control_words::title_words; i < words.size(); ++i) {
    if (i == control_words::release)
      out.text(d3plot_mark, bytes);
    else
      out.integer(words[i]);
  }
}

/// Positions and lengths of the lists, then the lists: node ids, segments numbered from 1, surfaces numbered from 1.
void put_numbering(const InterfaceMesh& mesh, WordBuffer& out) {
  const std::int64_t nodes = as_word(mesh.node_ids.size()), segments = as_word(mesh.segments.size()),
                     surfaces = as_word(mesh.surfaces.size());
  const std::int64_t behind_nodes = 1 + nodes, behind_segments = behind_nodes + segments;
  out.integers({-1, behind_nodes, behind_nodes, behind_nodes, behind_segments});
  out.integers({nodes, 0, 0, segments, 0});
  out.integers({behind_segments, behind_segments + surfaces, behind_segments + 2 * surfaces, surfaces, 0, surfaces});
  for (const std::int64_t id : mesh.node_ids) out.integer(id);
  for (std::int64_t i = 1; i <= segments; ++i) out.integer(i);
  for (int list = 0; list < 3; ++list)
    for (std::int64_t i = 1; i <= surfaces; ++i) out.integer(i);
}

void put_titles(const InterfaceMesh& mesh, WordBuffer& out) {
  out.real(d3plot_end);
  out.integers({surface_titles, as_word(mesh.surfaces.size())});
  for (std::size_t i = 0; i < mesh.surfaces.size(); ++i) {
    out.integer(as_word(i) + 1);
    out.text(column_text(surface_title(mesh.surfaces[i]), surface_title_bytes), surface_title_bytes);
  }
  out.real(d3plot_end);
}

}  // namespace

std::string surface_title(const InterfaceSurface& surface) {
  return fmt::format("contact {} side {}: {}", surface.contact, "AB"[surface.side & 1], surface.title);
}

InterfaceSurface surface_of_title(std::string_view title) {
  constexpr std::string_view before = "contact ", between = "side ";
  InterfaceSurface surface;
  if (!title.starts_with(before)) return surface;
  std::string_view rest = title.substr(before.size());
  const auto contact = take_integer(rest);
  rest = trimmed(rest);
  if (!contact || !rest.starts_with(between) || rest.size() <= between.size()) return surface;
  const char side = rest[between.size()];
  if (side != 'A' && side != 'B') return surface;
  surface.contact = *contact;
  surface.side = side == 'B' ? 1 : 0;
  rest.remove_prefix(between.size() + 1);
  if (rest.starts_with(':')) surface.title = trimmed(rest.substr(1));
  return surface;
}

Result<IntforWriter> IntforWriter::create(const std::string& path, const InterfaceMesh& mesh,
                                          const IntforWriteSettings& settings) {
  const auto fault = [&](const char* what) { return Diagnostic{Severity::error, path, 0, what}; };
  if (mesh.segments.empty()) return fault("an interface force database needs segments");
  if (mesh.coordinates.size() != mesh.node_ids.size() || mesh.surface_of.size() != mesh.segments.size())
    return fault("the arrays of an interface force database differ in size");
  const bool wide = std::any_of(mesh.node_ids.begin(), mesh.node_ids.end(),
                                [](std::int64_t id) { return id != static_cast<std::int32_t>(id); });
  IntforWriter writer;
  writer.word_bytes_ = settings.word_bytes == 8 || wide ? 8 : 4;
  writer.nodes_ = mesh.node_ids.size();
  writer.segments_ = mesh.segments.size();
  writer.surfaces_ = mesh.surfaces.size();
  WordBuffer out(writer.word_bytes_);
  put_control(mesh, writer.word_bytes_, out);
  for (const auto& x : mesh.coordinates) out.reals(x);
  for (std::size_t i = 0; i < mesh.segments.size(); ++i) {
    for (const std::uint32_t node : mesh.segments[i]) out.integer(std::int64_t{node} + 1);
    out.integer(std::int64_t{mesh.surface_of[i]} + 1);
  }
  put_numbering(mesh, out);
  put_titles(mesh, out);
  out.pad(D3plotWords::block_words);
  auto family = D3plotFamily::create(path, out.bytes(), writer.word_bytes_, settings.member_words);
  if (!family) return family.error();
  writer.family_ = std::move(family).value();
  return {std::move(writer)};
}

Status IntforWriter::append(const InterfaceForces& state) {
  if (state.coordinates.size() != nodes_ || state.velocities.size() != nodes_ || state.segments.size() != segments_)
    return Diagnostic{Severity::error, family_.path(), 0, "a state does not have the sizes of the mesh"};
  WordBuffer out(word_bytes_);
  out.real(state.time);
  out.zeros(static_cast<std::uint64_t>(first_globals) + static_cast<std::uint64_t>(surface_globals) * surfaces_);
  for (const auto& x : state.coordinates) out.reals(x);
  for (const auto& v : state.velocities) out.reals(v);
  for (const SegmentForce& segment : state.segments) {
    out.reals(std::array{segment.pressure, segment.shear, segment.shear_r, segment.shear_s});
    for (const auto& force : segment.force) out.reals(force);
  }
  return family_.append(std::move(out));
}

}  // namespace gapcheck::results
