#pragma once
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace gapcheck {

/// A number that identifies one kind of thing only: comparing or mixing two kinds does not compile.
template <class Tag, class Rep>
struct Typed {
  Rep value{};
  constexpr Typed() = default;
  constexpr explicit Typed(Rep v) : value(v) {}
  constexpr auto operator<=>(const Typed&) const = default;
  /// The next position.
  constexpr Typed& operator++() {
    ++value;
    return *this;
  }
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
using ContactIndex = Typed<struct ContactIndexTag, std::uint32_t>;  ///< in Model::contacts
using SegmentIndex = Typed<struct SegmentIndexTag, std::uint32_t>;  ///< in the segments of one side of a contact
using SlotIndex = Typed<struct SlotIndexTag, std::uint32_t>;        ///< in the tracked nodes of one side of a contact

/// "No such entry" of an index type.
template <class Index>
inline constexpr Index none{std::numeric_limits<decltype(Index::value)>::max()};

/// "No such entry" of positions that are plain numbers: those in arrays without an index type.
inline constexpr std::uint32_t no_position = std::numeric_limits<std::uint32_t>::max();

/// A number of entries, or a position among them, as an index.
template <class Index>
[[nodiscard]] constexpr Index to_index(std::size_t position) {
  return Index(static_cast<decltype(Index::value)>(position));
}

/// Positions one after the other: for (const SegmentIndex s : positions<SegmentIndex>(segments.size())).
template <class Index>
struct Positions {
  struct Iterator {
    Index at;
    constexpr Index operator*() const { return at; }
    constexpr Iterator& operator++() {
      ++at;
      return *this;
    }
    constexpr bool operator==(const Iterator&) const = default;
  };
  Index first, last;  ///< `last` is the one behind
  [[nodiscard]] constexpr Iterator begin() const { return {first}; }
  [[nodiscard]] constexpr Iterator end() const { return {last}; }
  [[nodiscard]] std::vector<Index> list() const {
    std::vector<Index> all;
    for (const Index index : *this) all.push_back(index);
    return all;
  }
};
template <class Index>
[[nodiscard]] constexpr Positions<Index> positions(std::size_t begin, std::size_t end) {
  return {to_index<Index>(begin), to_index<Index>(end)};
}
/// All positions of an array of this size.
template <class Index>
[[nodiscard]] constexpr Positions<Index> positions(std::size_t size) {
  return positions<Index>(0, size);
}

}  // namespace gapcheck

template <class Tag, class Rep>
struct std::hash<gapcheck::Typed<Tag, Rep>> {
  std::size_t operator()(gapcheck::Typed<Tag, Rep> id) const noexcept { return std::hash<Rep>{}(id.value); }
};
