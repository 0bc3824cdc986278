#pragma once
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>

namespace gapcheck {

/// A number that identifies one kind of thing only: comparing or mixing two kinds does not compile.
template <class Tag, class Rep>
struct Typed {
  Rep value{};
  constexpr Typed() = default;
  constexpr explicit Typed(Rep v) : value(v) {}
  constexpr auto operator<=>(const Typed&) const = default;
};

// Ids as written in the deck (any positive number, with gaps).
using NodeId = Typed<struct NodeIdTag, std::int64_t>;
using ElementId = Typed<struct ElementIdTag, std::int64_t>;
using PartId = Typed<struct PartIdTag, std::int64_t>;
using SetId = Typed<struct SetIdTag, std::int64_t>;
using ContactId = Typed<struct ContactIdTag, std::int64_t>;

// Positions in the arrays of a model or a surface (dense, from 0).
using NodeIndex = Typed<struct NodeIndexTag, std::uint32_t>;
using PartIndex = Typed<struct PartIndexTag, std::uint32_t>;
using FileIndex = Typed<struct FileIndexTag, std::uint32_t>;

/// "No such entry" of an index type.
template <class Index>
inline constexpr Index none{std::numeric_limits<decltype(Index::value)>::max()};

}  // namespace gapcheck

template <class Tag, class Rep>
struct std::hash<gapcheck::Typed<Tag, Rep>> {
  std::size_t operator()(gapcheck::Typed<Tag, Rep> id) const noexcept { return std::hash<Rep>{}(id.value); }
};
