#include "model/read/node_references.hpp"

#include <algorithm>
#include <array>
#include <unordered_set>

#include "keyword/card.hpp"
#include "model/read/cards.hpp"

namespace gapcheck::model {
namespace {

bool holds_nodes(IdKind kind) { return kind == IdKind::node || kind == IdKind::set; }

/// The cards of a keyword that can hold nodes or node sets. Constraints and elements with unknown cards are read as
/// rows of ids.
std::vector<const CardLayout*> cards_with_nodes(std::string_view name) {
  static const CardLayout nodes = id_line(8, 10, IdKind::node), sets = id_line(8, 10, IdKind::set),
                          element = element_line(8);
  const keyword::KeywordLayout* known = keyword::find_layout_of(name);
  if (known == nullptr && name.starts_with("CONSTRAINED_")) return {&nodes, &sets};
  if (known == nullptr && name.starts_with("ELEMENT_")) return {&element};
  std::vector<const CardLayout*> cards;
  if (known == nullptr) return cards;
  for (const CardLayout& card : known->cards)
    if (std::any_of(card.fields.begin(), card.fields.end(), [](const auto& f) { return holds_nodes(f.id); }))
      cards.push_back(&card);
  return cards;
}

class References {
 public:
  References(const keyword::Deck& deck, const Model& model)
      : deck_(deck), model_(model), used_(model.mesh.nodes.size()) {}

  void read(const keyword::Block& block) {
    const std::vector<const CardLayout*> cards = cards_with_nodes(block.name);
    if (cards.empty()) return;
    Diagnostics unused;
    for (keyword::CardReader reader(deck_, block, unused); !reader.at_end(); reader.skip())
      for (const CardLayout* layout : cards) mark(reader.peek(*layout), *layout);
  }

  [[nodiscard]] std::vector<std::uint8_t> take() { return std::move(used_); }

 private:
  void mark(const keyword::Card& card, const CardLayout& layout) {
    for (std::size_t i = 0; i < layout.fields.size(); ++i) {
      if (!holds_nodes(layout.fields[i].id)) continue;
      const std::int64_t id = card.integer(i);
      if (layout.fields[i].id == IdKind::node) {
        if (const auto node = model_.mesh.nodes.lookup.find(id)) used_[*node] = 1;
      } else if (const auto set = model_.sets.nodes.find(id);
                 set != model_.sets.nodes.end() && sets_.insert(id).second) {
        for (const NodeIndex node : set->second.members) used_[node.value] = 1;
      }
    }
  }

  const keyword::Deck& deck_;
  const Model& model_;
  std::vector<std::uint8_t> used_;
  std::unordered_set<std::int64_t> sets_;  ///< whose nodes are marked: many lines may name one set
};

}  // namespace

bool is_mesh(std::string_view name) {
  constexpr std::array<std::string_view, 9> mesh{"NODE",           "ELEMENT_SHELL",  "ELEMENT_SOLID",
                                                 "ELEMENT_TSHELL", "ELEMENT_SPH",    "SET_",
                                                 "CONTACT_",       "INITIAL_STRESS", "INITIAL_STRAIN"};
  return std::any_of(mesh.begin(), mesh.end(), [&](std::string_view family) { return name.starts_with(family); });
}

std::vector<std::uint8_t> referenced_nodes(const keyword::Deck& deck, const Model& model, std::string_view family) {
  return referenced_nodes(deck, model, [&](std::string_view name) { return name.starts_with(family); });
}

std::vector<std::uint8_t> referenced_nodes(const keyword::Deck& deck, const Model& model,
                                           const std::function<bool(std::string_view)>& chosen) {
  References references(deck, model);
  for (const keyword::Block& block : deck.blocks())
    if (!is_mesh(block.name) && chosen(block.name)) references.read(block);
  return references.take();
}

bool nodes_can_be_told(std::string_view keyword) { return !is_mesh(keyword) && !cards_with_nodes(keyword).empty(); }

}  // namespace gapcheck::model
