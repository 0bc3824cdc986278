#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <gapcheck/arrays.hpp>
#include <iterator>
#include <set>
#include <string_view>
#include <utility>

#include "api/convert.hpp"
#include "keyword/card.hpp"
#include "model/contact/contact_name.hpp"

namespace gapcheck::api {
namespace {

/// What the keyword of the contact says.
model::ContactName contact_name(const ShellMesh& mesh) {
  const std::string given = std::string(model::contact_prefix) + mesh.contact;
  return model::parse_contact_name(
      mesh.contact.empty() ? model::recommended_keyword(model::ContactCode::automatic_single).substr(1) : given);
}

/// What is wrong with the mesh; empty: nothing.
class MeshCheck {
 public:
  explicit MeshCheck(const ShellMesh& mesh) : mesh_(mesh) {}

  [[nodiscard]] std::string fault(const std::set<std::int64_t>& parts) const {
    for (std::string found : {lengths(), points(), shells(), part_ids(), thicknesses(parts), contact(parts)})
      if (!found.empty()) return found;
    return "";
  }

 private:
  [[nodiscard]] std::string lengths() const {
    if (mesh_.points.size() % 3 != 0) return fmt::format("points: {} numbers are not rows of 3", mesh_.points.size());
    if (mesh_.shells.size() % 4 != 0) return fmt::format("shells: {} numbers are not rows of 4", mesh_.shells.size());
    if (mesh_.shells.empty()) return "shells: there are none";
    if (!mesh_.parts.empty() && 4 * mesh_.parts.size() != mesh_.shells.size())
      return fmt::format("parts: {} ids for {} shells", mesh_.parts.size(), mesh_.shells.size() / 4);
    return "";
  }
  [[nodiscard]] std::string points() const {
    const auto bad = std::find_if_not(mesh_.points.begin(), mesh_.points.end(),
                                      [](double x) { return std::abs(x) <= keyword::Card::max_real; });
    if (bad == mesh_.points.end()) return "";
    return fmt::format("points, row {}: {} is not a number from {} to {}", (bad - mesh_.points.begin()) / 3, *bad,
                       -keyword::Card::max_real, keyword::Card::max_real);
  }
  [[nodiscard]] std::string shells() const {
    const auto rows = static_cast<std::int64_t>(mesh_.points.size() / 3);
    const auto bad = std::find_if(mesh_.shells.begin(), mesh_.shells.end(),
                                  [rows](std::int64_t row) { return row < 0 || row >= rows; });
    if (bad == mesh_.shells.end()) return "";
    return fmt::format("shells, row {}: {} is not one of the {} rows of points, which count from 0",
                       (bad - mesh_.shells.begin()) / 4, *bad, rows);
  }
  [[nodiscard]] std::string part_ids() const {
    const auto bad = std::find_if(mesh_.parts.begin(), mesh_.parts.end(), [](std::int64_t id) { return id < 1; });
    if (bad == mesh_.parts.end()) return "";
    return fmt::format("parts, row {}: {} is not an id of 1 or more", bad - mesh_.parts.begin(), *bad);
  }
  [[nodiscard]] std::string thicknesses(const std::set<std::int64_t>& parts) const {
    const auto is_length = [](double t) { return t > 0 && t <= keyword::Card::max_real; };
    for (const auto& [part, thickness] : mesh_.part_thickness) {
      if (!parts.contains(part)) return fmt::format("part_thickness: part {} has no shells", part);
      if (!is_length(thickness))
        return fmt::format("part_thickness, part {}: {} is not a length above 0", part, thickness);
    }
    const bool all_given = mesh_.part_thickness.size() == parts.size();
    if (!all_given && !is_length(mesh_.thickness))
      return fmt::format("thickness: {} is not a length above 0", mesh_.thickness);
    return "";
  }
  [[nodiscard]] std::string contact(const std::set<std::int64_t>& parts) const {
    const model::ContactName name = contact_name(mesh_);
    const model::ContactKind* kind = name.kind;
    const bool words = name.options != model::ContactOptions{.mortar = name.options.mortar};
    if (kind == nullptr || words || kind->cards != model::TypeCards::none || kind->treatment == model::Treatment::none)
      return fmt::format("contact: '{}' is not a type of contact between shells that has no cards of its own",
                         mesh_.contact);
    const bool single = kind->treatment == model::Treatment::single_surface;
    if (single && !mesh_.reference.empty()) return "reference: a single surface has no reference side";
    for (const auto& [side, ids] : {std::pair{"tracked", &mesh_.tracked}, {"reference", &mesh_.reference}})
      for (const std::int64_t id : *ids)
        if (!parts.contains(id)) return fmt::format("{}: part {} has no shells", side, id);
    return "";
  }

  const ShellMesh& mesh_;
};

/// The parts that have shells.
std::set<std::int64_t> parts_of(const ShellMesh& mesh) {
  if (mesh.parts.empty()) return {1};
  return {mesh.parts.begin(), mesh.parts.end()};
}

/// Card 1 of the contact, and the sets that it names.
template <class Out>
void append_surfaces(const ShellMesh& mesh, const std::set<std::int64_t>& parts, Out out) {
  const auto append_set = [&](int id, const std::vector<std::int64_t>& chosen) {
    fmt::format_to(out, "*SET_PART_LIST\n{}\n", id);
    for (const std::int64_t part : chosen.empty() ? std::vector<std::int64_t>(parts.begin(), parts.end()) : chosen)
      fmt::format_to(out, "{}\n", part);
  };
  const model::ContactName name = contact_name(mesh);
  const bool single = name.kind->treatment == model::Treatment::single_surface;
  append_set(1, mesh.tracked);
  if (!single) append_set(2, mesh.reference);
  fmt::format_to(out, "*{}_ID\n1\n{}\n0.\n1.,1.\n", name.bare, single ? "1,0,2,0" : "1,2,2,2");
}

}  // namespace

Result<std::string> shell_deck(const ShellMesh& mesh) {
  const std::set<std::int64_t> parts = parts_of(mesh);
  if (std::string fault = MeshCheck(mesh).fault(parts); !fault.empty()) return plain_error(std::move(fault));
  std::string text = "*KEYWORD\n*MAT_ELASTIC\n1,7.85e-9,210000.,0.3\n";
  const auto out = std::back_inserter(text);
  // Fields between commas have no width, and the shortest text that gives the same number back keeps all digits.
  for (const std::int64_t part : parts) {
    const auto own = mesh.part_thickness.find(part);
    fmt::format_to(out, "*SECTION_SHELL\n{},2\n{}\n*PART\npart {}\n{},{},1\n", part,
                   own == mesh.part_thickness.end() ? mesh.thickness : own->second, part, part, part);
  }
  fmt::format_to(out, "*NODE\n");
  const double* x = mesh.points.data();
  for (std::size_t i = 0; i < mesh.points.size() / 3; ++i, x += 3)
    fmt::format_to(out, "{},{},{},{}\n", i + 1, x[0], x[1], x[2]);
  fmt::format_to(out, "*ELEMENT_SHELL\n");
  const std::int64_t* n = mesh.shells.data();
  for (std::size_t i = 0; i < mesh.shells.size() / 4; ++i, n += 4)
    fmt::format_to(out, "{},{},{},{},{},{}\n", i + 1, mesh.parts.empty() ? 1 : mesh.parts[i], n[0] + 1, n[1] + 1,
                   n[2] + 1, n[3] + 1);
  append_surfaces(mesh, parts, out);
  text += "*END\n";
  return text;
}

Result<Report> audit_arrays(const ShellMesh& mesh, const AuditOptions& options) {
  Result<std::string> deck = shell_deck(mesh);
  if (!deck) return deck.error();
  return audit_text(std::move(deck).value(), "arrays", options);
}

}  // namespace gapcheck::api
