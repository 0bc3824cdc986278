#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "model/entity/part.hpp"

namespace gapcheck::model {

/// What a set is made of.
enum class SetKind : std::uint8_t {
  node,
  part,
  segment,
  shell,
  solid,
  thick_shell,
  beam,
  discrete,
  branch,  ///< *SET_PART_TREE: parts and other branches
};
inline constexpr std::size_t set_kinds = 9;
[[nodiscard]] std::string_view name(SetKind kind);

/// One step of a set's definition: which things are added (or removed).
struct SetClause {
  enum class Source : std::uint8_t {
    members,     ///< ids of kind `of` (segments: four node ids each)
    ranges,      ///< pairs first, last
    increments,  ///< triples first, last, step
    sets,        ///< ids of sets of kind `of`
    intersect,   ///< ids of sets of the same kind; their common members
    boxes,       ///< *DEFINE_BOX ids
    all,
  };
  Source source = Source::members;
  SetKind of = SetKind::node;
  bool remove = false;
  std::vector<std::int64_t> ids;
};

/// A set as written, before its members are resolved.
struct RawSet {
  std::int64_t id = 0;
  std::string title;
  std::array<double, 4> defaults{};
  Place place;
  bool collect = false;
  std::vector<SetClause> clauses;
};

struct RawSets {
  std::array<std::map<std::int64_t, RawSet>, set_kinds> of_kind;
  [[nodiscard]] std::map<std::int64_t, RawSet>& of(SetKind kind) { return of_kind[static_cast<std::size_t>(kind)]; }
};

}  // namespace gapcheck::model
