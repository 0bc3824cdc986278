#pragma once
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "keyword/deck.hpp"
#include "model/model.hpp"

namespace gapcheck::model {

/// Keywords that only define positions, or that the model holds in another form: nobody reads their text again once
/// there is a model, except to correct it.
[[nodiscard]] bool is_mesh(std::string_view name);

/// Nodes that keywords other than mesh keywords refer to: parallel to Nodes, 1 for every node whose id is in a node
/// field, or whose node set is in a set field, of a block whose name begins with `family` (empty: any). Elements,
/// nodes, sets and contacts are skipped. A line is read as each of the keyword's cards, so that too many nodes are
/// marked rather than too few; keywords with unknown cards are skipped. Meant for the few decks where it matters: the
/// cost is that of reading the blocks.
[[nodiscard]] std::vector<std::uint8_t> referenced_nodes(const keyword::Deck& deck, const Model& model,
                                                         std::string_view family);

/// The same for blocks whose name `chosen` accepts.
[[nodiscard]] std::vector<std::uint8_t> referenced_nodes(const keyword::Deck& deck, const Model& model,
                                                         const std::function<bool(std::string_view)>& chosen);

/// True if referenced_nodes() can tell which nodes a keyword names.
[[nodiscard]] bool nodes_can_be_told(std::string_view keyword);

}  // namespace gapcheck::model
