#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "scenes/deck_writer.hpp"

namespace gapcheck::bench {

/// Decks that ask for different things of a search.
enum class SceneKind : std::uint8_t {
  plates,      ///< two stacked plates (plates.hpp)
  airbag,      ///< a cloth folded into up to 40 layers, 0.2 apart and 0.5 thick: one part, all of it in contact
  vehicle,     ///< thousands of parts with elements of 1 to 100, turned at random, in pairs with gaps or penetrations
  tubes,       ///< bundles of long thin tubes and strips with elements of aspect ratio 3 to 10, askew to the axes
  huge_facet,  ///< one facet under a whole fine plate
  cluster,     ///< two fine plates in a corner of a model 10^8 wide: nearly all nodes in one cell of any even grid
  blocks,      ///< two blocks of bricks, half as high as wide, of which the upper one sinks into the lower one
};

inline constexpr std::array all_scenes{SceneKind::plates,     SceneKind::airbag,  SceneKind::vehicle, SceneKind::tubes,
                                       SceneKind::huge_facet, SceneKind::cluster, SceneKind::blocks};

/// "plates", "airbag", "vehicle", "tubes", "huge-facet", "cluster", "blocks".
[[nodiscard]] std::string_view name(SceneKind kind);
[[nodiscard]] std::optional<SceneKind> scene_kind(std::string_view name);

/// What a deck has, and between which numbers the penetrations of all its contacts are (nodes in the band of a
/// segment, as counted in ContactSummary::penetrations, or in its edge zone).
struct SceneFacts {
  std::uint64_t nodes = 0, elements = 0;
  std::uint64_t fewest_penetrations = 0, most_penetrations = 0;
};

/// Writes the deck of a scene with about so many elements: at least 1000, at most 50 million. The same bytes every
/// time.
SceneFacts write_scene(SceneKind kind, std::uint64_t elements, const DeckSink& sink);

/// The plates of plates.hpp. n: shells along an edge.
SceneFacts write_plates(int n, bool stray, const DeckSink& sink);

}  // namespace gapcheck::bench
