#include "keyword/include_transforms.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "keyword/transformation.hpp"

namespace gapcheck::keyword {
namespace {

double factor(const Card& card, std::string_view field) {
  const double value = card.real(field);
  return value == 0 ? 1 : value;
}

void read_offset(Transform& transform, IdKind kind, const Card& card, std::string_view field) {
  transform.offset[static_cast<std::size_t>(kind)] = card.integer(field);
}

using Definitions = std::map<std::int64_t, const Block*>;

Definitions find_definitions(const std::vector<std::uint32_t>& positions, const Deck& deck, Diagnostics& diagnostics) {
  Definitions definitions;
  for (const std::uint32_t position : positions) {
    const Block& block = deck.blocks()[position];
    const std::int64_t id = transformation_id(deck, block, diagnostics);
    if (!definitions.emplace(id, &block).second)
      diagnostics.error(deck.file(block.file).path, block.line,
                        "*DEFINE_TRANSFORMATION " + std::to_string(id) + " is defined again; remove one of them");
  }
  return definitions;
}

}  // namespace

IncludeTransform read_include_transform(CardReader& reader) {
  IncludeTransform include;
  Transform& own = include.own;
  const Card ids = reader.next(card_layout("INCLUDE_TRANSFORM", "card2"));
  read_offset(own, IdKind::node, ids, "idnoff");
  read_offset(own, IdKind::element, ids, "ideoff");
  read_offset(own, IdKind::part, ids, "idpoff");
  read_offset(own, IdKind::material, ids, "idmoff");
  read_offset(own, IdKind::set, ids, "idsoff");
  read_offset(own, IdKind::function, ids, "idfoff");
  read_offset(own, IdKind::define, ids, "iddoff");
  read_offset(own, IdKind::other, reader.next(card_layout("INCLUDE_TRANSFORM", "card3")), "idroff");
  const Card factors = reader.next(card_layout("INCLUDE_TRANSFORM", "card4"));
  own.mass_factor = factor(factors, "fctmas");
  own.time_factor = factor(factors, "fcttim");
  own.length_factor = factor(factors, "fctlen");
  const Card last = reader.next(card_layout("INCLUDE_TRANSFORM", "card5"));
  include.transformation = last.integer("tranid");
  include.line = last.line();
  return include;
}

IncludeTransform read_include_offsets(CardReader& reader) {
  IncludeTransform include;
  include.line = reader.block().line;
  const Card ids = reader.next(card_layout("INCLUDE_AUTO_OFFSET_USER", "card2"));
  read_offset(include.own, IdKind::node, ids, "noffset");
  read_offset(include.own, IdKind::element, ids, "neoffset");
  return include;
}

TransformIndex IncludeTransforms::add(std::vector<Transform>& all, TransformIndex parent,
                                      const IncludeTransform& include, const Block& block, const std::string& path,
                                      Diagnostics& diagnostics) {
  const Transform& own = include.own;
  Transform total = all[parent.value];
  for (std::size_t i = 0; i < total.offset.size(); ++i)
    if (__builtin_add_overflow(total.offset[i], own.offset[i], &total.offset[i])) {
      diagnostics.error(path, block.line, "*" + block.name + ": the id offset is too large");
      total.offset[i] = 0;
    }
  total.automatic = total.automatic || own.automatic;
  total.length_factor *= own.length_factor;
  total.mass_factor *= own.mass_factor;
  total.time_factor *= own.time_factor;
  const TransformIndex index(static_cast<std::uint32_t>(all.size()));
  all.push_back(total);
  pending_.push_back({index, parent, include.transformation, block.file, include.line});
  return index;
}

void IncludeTransforms::resolve(std::vector<Transform>& all, const Deck& deck, Diagnostics& diagnostics) const {
  if (std::none_of(pending_.begin(), pending_.end(), [](const Pending& each) { return each.transformation != 0; }))
    return;
  const Definitions definitions = find_definitions(definitions_, deck, diagnostics);
  std::map<std::int64_t, std::optional<Placement>> placements;
  for (const Pending& pending : pending_) {
    Placement own;
    if (pending.transformation != 0) {
      const auto definition = definitions.find(pending.transformation);
      if (definition == definitions.end()) {
        diagnostics.error(deck.file(pending.file).path, pending.line,
                          "*INCLUDE_TRANSFORM refers to transformation " + std::to_string(pending.transformation) +
                              ", which is not defined; add *DEFINE_TRANSFORMATION or clear TRANID");
      } else {
        const auto [entry, is_new] = placements.try_emplace(pending.transformation);
        if (is_new) entry->second = read_transformation(deck, *definition->second, diagnostics);
        own = entry->second.value_or(Placement{});
      }
    }
    const Transform& parent = all[pending.parent.value];
    Transform& total = all[pending.own.value];
    total.places = pending.transformation != 0 || parent.places;
    total.matrix = parent.matrix * own.matrix;
    total.shift = parent.length_factor * (parent.matrix * own.shift) + parent.shift;
  }
}

}  // namespace gapcheck::keyword
