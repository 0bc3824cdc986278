#pragma once
#include <cstdint>
#include <string>

#include "audit/rule.hpp"

namespace gapcheck::audit {

/// An element of the mesh; `index` is its position in the array of its kind, or no_position.
struct ElementRef {
  model::ElementKind kind = model::ElementKind::shell;
  std::uint32_t index = no_position;
};

/// "shell 12"; "a segment" for one without element.
[[nodiscard]] std::string element_text(const model::Mesh& mesh, ElementRef element);
/// Id of the element; 0 for none.
[[nodiscard]] std::int64_t element_id(const model::Mesh& mesh, ElementRef element);
/// Id of a part; 0 for none.
[[nodiscard]] std::int64_t part_id(const model::Model& model, PartIndex part);
/// "part 3"; "no part" for none.
[[nodiscard]] std::string part_text(const model::Model& model, PartIndex part);
/// Fills file, line and element id of a finding.
void place_at_element(Finding& finding, const Context& context, ElementRef element);
/// "(1, 2.5, 3)".
[[nodiscard]] std::string point_text(const Vector& x);

}  // namespace gapcheck::audit
