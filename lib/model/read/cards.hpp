#pragma once
#include <cstdint>
#include <initializer_list>
#include <string_view>

#include "keyword/layout.hpp"

namespace gapcheck::model {

using keyword::CardLayout;
using keyword::FieldType;
using keyword::IdKind;

/// Cards shared by many keywords. Fields are read by position.

/// One line of text, 80 wide.
[[nodiscard]] const CardLayout& text_line();
/// `eid pid n1 … nN`, eight columns each; an element of any kind.
[[nodiscard]] CardLayout element_line(std::size_t nodes);
/// `count` fields of one kind of id, `width` columns each.
[[nodiscard]] CardLayout id_line(std::size_t count, std::uint16_t width, IdKind kind);
/// `count` reals, `width` columns each.
[[nodiscard]] CardLayout real_line(std::size_t count, std::uint16_t width);
/// `id x1 … xN`, ten columns each.
[[nodiscard]] CardLayout id_and_reals(IdKind kind, std::size_t reals);

}  // namespace gapcheck::model
