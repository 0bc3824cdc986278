#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string_view>

namespace gapcheck {

/// What can be done about the penetrations between two parts. In the order in which repairs of equal cost are ranked.
enum class RepairKind : std::uint8_t {
  move,               ///< nodes, by the least movement
  part_thickness,     ///< OPTT of both parts
  contact_thickness,  ///< SST and MST of the contact
  sections,           ///< T1 … T4 of the parts' sections
  ignore,             ///< IGNORE = 1: the penetration stays, without force
  tie,                ///< the parts are joined
  exclude,            ///< no contact between the parts
  swap,               ///< the sides of a one-way contact change places
  reach,              ///< a negative SST lets a tied contact reach farther
};
/// True for repairs that change what two parts do to each other for good: nobody can choose them but the user.
[[nodiscard]] constexpr bool changes_the_model(RepairKind kind) { return kind >= RepairKind::tie; }
/// "move", "optt", "sst", "sections", "ignore", "tie", "exclude", "swap", "reach".
[[nodiscard]] std::string_view name(RepairKind kind);

/// Two parts in a contact; ids.
struct RepairParts {
  std::int64_t contact = 0, a = 0, b = 0;
  auto operator<=>(const RepairParts&) const = default;
};

/// What one repair or several together set in a deck. Contacts are positions in the model's list.
struct RepairSettings {
  bool move = false;
  std::map<std::uint32_t, std::array<double, 2>> contact_thickness;  ///< SST, MST; negative of ties
  std::map<std::int64_t, double> part_thickness;                     ///< OPTT by part id
  std::map<std::int64_t, double> section_thickness;                  ///< T1 … T4 by section id
  std::set<std::uint32_t> ignore, swapped;
  std::set<RepairParts> tied, excluded;
  /// Both together; of two thicknesses the smaller one.
  void add(const RepairSettings& other);
  /// True if it changes nothing but coordinates.
  [[nodiscard]] bool only_moves() const;
};

}  // namespace gapcheck
