#include "model/read/links.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>

#include "model/read/context.hpp"

namespace gapcheck::model {
namespace {

constexpr std::string_view node_set = "CONSTRAINED_NODE_SET", rivet = "CONSTRAINED_RIVET",
                           hanging_node = "CONSTRAINED_ADAPTIVITY", id_option = "_ID";

/// True for the keyword itself and its form with an id.
bool is(std::string_view name, std::string_view keyword) {
  return name.starts_with(keyword) && (name.size() == keyword.size() || name.substr(keyword.size()) == id_option);
}

class Reader {
 public:
  Reader(const keyword::Deck& deck, const Model& model, Diagnostics& diagnostics)
      : deck_(deck), model_(model), diagnostics_(diagnostics) {}

  void read(const Block& block) {
    if (is(block.name, node_set)) read_node_sets(block);
    if (is(block.name, rivet)) read_rivets(block);
    if (block.name == hanging_node) read_hanging_nodes(block);
  }
  [[nodiscard]] Links take() { return std::move(links_); }

 private:
  void read_node_sets(const Block& block) {
    const auto& id_layout = keyword::card_layout("CONSTRAINED_NODE_SET", "ID");
    const auto& layout = keyword::card_layout("CONSTRAINED_NODE_SET", "card1");
    for_each_row(block, [&](CardReader& reader) {
      NodeLink link{NodeLink::Kind::node_set, read_id(block, reader, id_layout), {}, 0, 0, {}};
      const Card card = reader.next(layout);
      link.place = {block.file, card.line()};
      link.freedoms = freedoms_of_code(card.integer("dof"));
      link.failure_time = card.real("tf") * deck_.transform(block.transform).time_factor;
      const std::int64_t id = card.integer("nsid");
      const auto set = model_.sets.nodes.find(id);
      if (set == model_.sets.nodes.end()) return warn(link.place, block, fmt::format("node set {}", id));
      link.nodes = set->second.members;
      links_.joined.push_back(std::move(link));
    });
  }

  void read_rivets(const Block& block) {
    const auto& id_layout = keyword::card_layout("CONSTRAINED_RIVET", "ID");
    const auto& layout = keyword::card_layout("CONSTRAINED_RIVET", "card1");
    for_each_row(block, [&](CardReader& reader) {
      NodeLink link{NodeLink::Kind::rivet, read_id(block, reader, id_layout), {}, 7, 0, {}};
      const Card card = reader.next(layout);
      link.place = {block.file, card.line()};
      link.failure_time = card.real("tf") * deck_.transform(block.transform).time_factor;
      const auto first = node(block, card, "n1"), second = node(block, card, "n2");
      if (!first || !second) return;
      link.nodes = {*first, *second};
      links_.joined.push_back(std::move(link));
    });
  }

  void read_hanging_nodes(const Block& block) {
    const auto& layout = keyword::card_layout("CONSTRAINED_ADAPTIVITY", "card1");
    for_each_row(block, [&](CardReader& reader) {
      const Card card = reader.next(layout);
      const auto hanging = node(block, card, "dnid"), a = node(block, card, "nid1"), b = node(block, card, "nid2");
      if (hanging && a && b) links_.hanging.push_back({*hanging, {*a, *b}, {block.file, card.line()}});
    });
  }

  /// Visits the rows of a block; blank lines between them are skipped.
  template <class Visit>
  void for_each_row(const Block& block, const Visit& visit) {
    CardReader reader(deck_, block, diagnostics_);
    while (!reader.at_end())
      if (!skip_blank(reader)) visit(reader);
  }

  /// The number on the card before each link of the form with an id.
  static std::int64_t read_id(const Block& block, CardReader& reader, const keyword::CardLayout& layout) {
    return block.name.ends_with(id_option) ? reader.next(layout).integer(0) : 0;
  }

  std::optional<NodeIndex> node(const Block& block, const Card& card, std::string_view field) {
    const std::int64_t id = card.integer(field);
    if (const auto found = model_.mesh.nodes.lookup.find(id)) return NodeIndex{*found};
    warn({block.file, card.line()}, block, fmt::format("node {}", id));
    return std::nullopt;
  }

  void warn(Place place, const Block& block, const std::string& what) {
    diagnostics_.warning(model_.file(place), place.line,
                         fmt::format("*{} names {}, which is not defined; it is left out", block.name, what));
  }

  const keyword::Deck& deck_;
  const Model& model_;
  Diagnostics& diagnostics_;
  Links links_;
};

}  // namespace

Links read_links(const keyword::Deck& deck, const Model& model, Diagnostics& diagnostics) {
  Reader reader(deck, model, diagnostics);
  for (const Block& block : deck.blocks()) reader.read(block);
  return reader.take();
}

bool is_link(std::string_view name) { return is(name, node_set) || is(name, rivet) || name == hanging_node; }

}  // namespace gapcheck::model
