#include "audit/shared/element_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gapcheck::audit {
namespace {

/// Calls use(array of the element's kind, its name) if the element is known.
template <class Use>
void with_array(const model::Mesh& mesh, ElementRef element, const Use& use) {
  const auto known = [&](const auto& array, const char* name) {
    if (element.index < array.size()) use(array, name);
  };
  switch (element.kind) {
    case model::ElementKind::shell:
      return known(mesh.shells, "shell");
    case model::ElementKind::solid:
      return known(mesh.solids, "solid");
    case model::ElementKind::thick_shell:
      return known(mesh.thick_shells, "thick shell");
    case model::ElementKind::beam:
      return known(mesh.beams, "beam");
    default:
      return;
  }
}

}  // namespace

std::string element_text(const model::Mesh& mesh, ElementRef element) {
  std::string text = "a segment";
  with_array(mesh, element,
             [&](const auto& array, const char* name) { text = fmt::format("{} {}", name, array.id[element.index]); });
  return text;
}

std::int64_t element_id(const model::Mesh& mesh, ElementRef element) {
  std::int64_t id = 0;
  with_array(mesh, element, [&](const auto& array, const char*) { id = array.id[element.index]; });
  return id;
}

std::int64_t part_id(const model::Model& model, PartIndex part) {
  return part == none<PartIndex> ? 0 : model.part(part).id.value;
}

std::string part_text(const model::Model& model, PartIndex part) {
  return part == none<PartIndex> ? "no part" : fmt::format("part {}", part_id(model, part));
}

void place_at_element(Finding& finding, const Context& context, ElementRef element) {
  with_array(context.model().mesh, element, [&](const auto& array, const char*) {
    finding.element = array.id[element.index];
    finding.file = context.path(array.origins.file(element.index));
    finding.line = array.line[element.index];
  });
}

std::string point_text(const Vector& x) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", x.x(), x.y(), x.z()); }

}  // namespace gapcheck::audit
