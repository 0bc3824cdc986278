#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "base/ids.hpp"
#include "base/vector.hpp"
#include "model/entity/part.hpp"

namespace gapcheck::model {

/// File of each row range of an array: entities were read block by block.
class Origins {
 public:
  /// Entities from `first` on (until the next call's `first`) come from `file`. Calls with rising `first`.
  void add(std::uint32_t first, FileIndex file) { ranges_.emplace_back(first, file); }
  [[nodiscard]] FileIndex file(std::uint32_t index) const;

 private:
  std::vector<std::pair<std::uint32_t, FileIndex>> ranges_;
};

/// From an id of the deck to a position in an array: a direct table where ids are dense, a sorted list otherwise.
class IdLookup {
 public:
  /// Builds from ids in array order; of equal ids the first wins. Returns the positions of all later duplicates,
  /// ascending.
  std::vector<std::uint32_t> build(const std::vector<std::int64_t>& ids);
  [[nodiscard]] std::optional<std::uint32_t> find(std::int64_t id) const {
    if (!table_.empty()) {
      const std::uint64_t place = static_cast<std::uint64_t>(id) - static_cast<std::uint64_t>(lowest_);
      if (place >= table_.size() || table_[place] == no_position) return std::nullopt;
      return table_[place];
    }
    const auto found = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair{id, std::uint32_t{0}});
    if (found == sorted_.end() || found->first != id) return std::nullopt;
    return found->second;
  }
  /// Calls visit(id, position) for all ids in [first, last], ascending, until it returns false. The cost is bounded by
  /// the number of entities, however long the range is.
  template <class Visit>
  void for_each_in(std::int64_t first, std::int64_t last, const Visit& visit) const {
    if (!table_.empty()) {
      const std::int64_t highest = lowest_ + static_cast<std::int64_t>(table_.size()) - 1;
      if (first > highest || last < lowest_) return;
      const auto begin = static_cast<std::size_t>(std::max(first, lowest_) - lowest_);
      const auto end = static_cast<std::size_t>(std::min(last, highest) - lowest_);
      for (std::size_t i = begin; i <= end; ++i)
        if (table_[i] != no_position && !visit(lowest_ + static_cast<std::int64_t>(i), table_[i])) return;
      return;
    }
    auto entry = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair{first, std::uint32_t{0}});
    for (; entry != sorted_.end() && entry->first <= last; ++entry)
      if (!visit(entry->first, entry->second)) return;
  }

 private:
  std::int64_t lowest_ = 0;
  std::vector<std::uint32_t> table_;  ///< by id - lowest_; or no_position
  std::vector<std::pair<std::int64_t, std::uint32_t>> sorted_;
};

/// All nodes, in input order. Every array has the same length.
struct Nodes {
  std::vector<std::int64_t> id;
  std::vector<Vector> x;
  std::vector<std::uint32_t> line;
  Origins origins;
  IdLookup lookup;
  [[nodiscard]] std::size_t size() const { return id.size(); }
};

enum class ElementKind : std::uint8_t { shell, solid, thick_shell, beam, discrete, mass, particle };

/// Elements of one kind with N nodes each, in input order; every array has the same length. Unused node slots repeat
/// the last node used (triangle: n3 = n4; tetrahedron: n4 … n8 equal; wedge and pyramid as in the deck).
template <std::size_t N>
struct Elements {
  std::vector<std::int64_t> id;
  std::vector<std::array<NodeIndex, N>> nodes;
  std::vector<PartIndex> part;
  std::vector<std::uint32_t> line;
  Origins origins;
  IdLookup lookup;
  [[nodiscard]] std::size_t size() const { return id.size(); }
};

/// Thickness at the four nodes of one shell (0 = take the section's) from *ELEMENT_SHELL_THICKNESS and relatives.
struct ShellThickness {
  std::uint32_t shell;
  std::array<double, 4> thickness;
};

/// Normal offset of one shell's mid-surface from *ELEMENT_SHELL_OFFSET.
struct ShellOffset {
  std::uint32_t shell;
  double offset;
};

/// The plies of *ELEMENT_SHELL_COMPOSITE, from the lower side.
struct Layup {
  std::vector<Ply> plies;
  double thickness = 0;  ///< their sum
  Place place;           ///< of the first element that has them
};

struct ShellLayup {
  std::uint32_t shell;
  std::uint32_t layup;
};

struct Shells : Elements<4> {
  std::vector<ShellThickness> own_thickness;  ///< ascending by shell, only shells that have one
  std::vector<ShellOffset> own_offset;        ///< ascending by shell
  std::vector<Layup> layups;                  ///< different ones, at least within one keyword block
  std::vector<ShellLayup> own_layup;          ///< ascending by shell, only shells that have one
  /// The position of a shell's own layup; nothing if its part says what it is made of.
  [[nodiscard]] std::optional<std::uint32_t> layup_of(std::uint32_t shell) const {
    const auto own = std::lower_bound(own_layup.begin(), own_layup.end(), shell,
                                      [](const ShellLayup& one, std::uint32_t wanted) { return one.shell < wanted; });
    return own != own_layup.end() && own->shell == shell ? std::optional(own->layup) : std::nullopt;
  }
};

/// What *ELEMENT_BEAM says besides part and end nodes.
struct BeamValues {
  NodeIndex third = none<NodeIndex>;       ///< N3, in the plane of the axes r and s
  Vector orientation = Vector::Zero();     ///< _ORIENTATION: from the first node to a third one; zero: not given
  std::array<std::uint8_t, 4> releases{};  ///< RT1, RR1, RT2, RR2: bits 1, 2, 4 for the axes r, s, t
  bool global_releases = false;            ///< LOCAL = 1: about x, y, z instead
  std::array<Vector, 2> offsets{Vector::Zero(), Vector::Zero()};  ///< _OFFSET: of the ends from their nodes
  [[nodiscard]] bool released() const { return releases != std::array<std::uint8_t, 4>{}; }
  [[nodiscard]] bool shifted() const { return !offsets[0].isZero(0) || !offsets[1].isZero(0); }
};

/// What *ELEMENT_DISCRETE says besides part and nodes.
struct DiscreteValues {
  std::int64_t orientation = 0;  ///< VID; 0: along the line between the nodes
  double scale = 1;              ///< S, on forces
  double offset = 0;             ///< elongation (or angle) at the start
  bool printed = true;           ///< PF: its forces are in deforc
};

struct Mesh {
  Nodes nodes;
  Shells shells;
  Elements<8> solids;
  Elements<8> thick_shells;
  Elements<2> beams;                            ///< the two end nodes
  std::vector<BeamValues> beam_values;          ///< beside beams
  Elements<2> discrete;                         ///< springs and dampers; the second node may be none: the ground
  std::vector<DiscreteValues> discrete_values;  ///< beside discrete
  Elements<1> masses;                           ///< *ELEMENT_MASS; part may be none
  std::vector<double> mass_values;              ///< beside masses
  Elements<1> particles;                        ///< *ELEMENT_SPH
};

}  // namespace gapcheck::model
