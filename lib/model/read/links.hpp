#pragma once
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "keyword/deck.hpp"
#include "model/model.hpp"

namespace gapcheck::model {

/// Nodes that a keyword joins without an element between them: *CONSTRAINED_NODE_SET, *CONSTRAINED_RIVET.
struct NodeLink {
  enum class Kind : std::uint8_t { node_set, rivet } kind;
  std::int64_t id = 0;           ///< given, or 0
  std::vector<NodeIndex> nodes;  ///< of a rivet two
  std::uint8_t freedoms = 7;     ///< translations that they share: bits 0 … 2; rivets keep all
  double failure_time = 0;       ///< in the model's unit; 0: none
  Place place;
};

/// *CONSTRAINED_ADAPTIVITY: a node on the edge between two others, where a fine mesh meets a coarse one.
struct HangingNode {
  NodeIndex node;
  std::array<NodeIndex, 2> between{};
  Place place;
};

/// In input order.
struct Links {
  std::vector<NodeLink> joined;
  std::vector<HangingNode> hanging;
};

/// Reads the links of a deck for code that moves its nodes; the model itself does not need them. `model`: read from
/// `deck`. Undefined nodes and sets are warnings, and links that name them are left out.
[[nodiscard]] Links read_links(const keyword::Deck& deck, const Model& model, Diagnostics& diagnostics);

/// True for the keywords that read_links() reads.
[[nodiscard]] bool is_link(std::string_view keyword);

}  // namespace gapcheck::model
