#include "audit/repair/repair_cards.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <tuple>
#include <utility>

#include "audit/repair/card_fields.hpp"
#include "audit/repair/part_cards.hpp"
#include "audit/shared/free_thickness.hpp"
#include "model/contact/contact_cards.hpp"

namespace gapcheck::audit {
namespace {

/// Cards of one contact.
class ContactCards {
 public:
  ContactCards(CardFields& fields, const model::Contact& contact) : fields_(fields), contact_(contact) {}

  Status thickness(const std::array<double, 2>& value) {
    if (Status status = prepare(); !status.ok()) return status;
    const std::uint32_t line = contact_.lines.card3;
    if (line == 0) {
      std::string cards = contact_.lines.card2 == 0 ? first_zero("card2") + "\n" : "";
      cards += CardFields::card(
          *block_, model::contact_card_layout("card3"),
          std::array<std::pair<std::string_view, double>, 2>{{{"sast", value[0]}, {"sbst", value[1]}}});
      fields_.edits().insert_behind(place().file, contact_.lines.last, cards);
      return {};
    }
    for (const auto& [field, number, present] :
         {std::tuple{"sast", value[0], contact_.sst}, std::tuple{"sbst", value[1], contact_.mst}})
      if (number == present) {
        continue;
      } else if (Status status = fields_.set(*block_, line, model::contact_card_layout("card3"), field, number);
                 !status.ok())
        return status;
    return {};
  }

  /// `has_card3`: thickness() has been called, so that cards 2 and 3 are there.
  Status ignore(bool has_card3) {
    if (Status status = prepare(); !status.ok()) return status;
    if (contact_.mpp_ignore)
      return fields_.set_text(*block_, contact_.lines.mpp, model::contact_card_layout("MPP1"), "ignore", "1");
    constexpr std::array<std::string_view, 2> before{"A", "B"};
    if (contact_.lines.optional[2] != 0)
      return fields_.set_text(*block_, contact_.lines.optional[2], model::contact_card_layout("C"), "ignore", "1");
    // Cards that come before A, and whether there are any, depend on the type and the options of the keyword.
    const model::ContactOptions& options = contact_.options;
    if (!contact_.cards.missing.empty() && (contact_.kind->cards != model::TypeCards::none || options.thermal ||
                                            options.thermal_friction || options.ortho_friction))
      return fields_.error(place(),
                           fmt::format("contact {} ends before {}", contact_.id.value, contact_.cards.missing));
    std::string cards;
    if (contact_.lines.card2 == 0 && !has_card3) cards += first_zero("card2") + "\n";
    if (contact_.lines.card3 == 0 && !has_card3) cards += first_zero("card3") + "\n";
    for (std::size_t i = 0; i < before.size(); ++i)
      if (contact_.lines.optional[i] == 0) cards += first_zero(before[i]) + "\n";
    cards +=
        keyword::card_line(model::contact_card_layout("C"), block_->format,
                           std::array<std::pair<std::string_view, std::string>, 2>{{{"igap", "1"}, {"ignore", "1"}}});
    fields_.edits().insert_behind(place().file, contact_.lines.last, cards);
    return {};
  }

  Status swap() {
    if (Status status = prepare(); !status.ok()) return status;
    constexpr std::array<std::pair<std::string_view, std::string_view>, 4> sides{
        {{"surfa", "surfb"}, {"surfatyp", "surfbtyp"}, {"saboxid", "sbboxid"}, {"sapr", "sbpr"}}};
    constexpr std::array<std::pair<std::string_view, std::string_view>, 3> stiffness{
        {{"sfsa", "sfsb"}, {"sast", "sbst"}, {"sfsat", "sfsbt"}}};
    for (const auto& [a, b] : sides)
      if (Status status = swap("card1", contact_.lines.card1, a, b); !status.ok()) return status;
    for (const auto& [a, b] : stiffness)
      if (Status status = swap("card3", contact_.lines.card3, a, b); !status.ok()) return status;
    return {};
  }

 private:
  [[nodiscard]] const model::Place& place() const { return contact_.place; }

  /// Finds the block; an error if its cards are not those that were read.
  Status prepare() {
    block_ = fields_.block(place());
    if (block_ == nullptr || contact_.lines.last == 0)
      return fields_.error(place(), fmt::format("the cards of contact {} were not read", contact_.id.value));
    if (contact_.cards.misread != 0 || contact_.cards.surplus != 0)
      return fields_.error(place(),
                           fmt::format("the lines of contact {} are not those of its type", contact_.id.value));
    return fields_.check(*block_);
  }

  /// A card of defaults.
  [[nodiscard]] std::string first_zero(std::string_view card) const {
    const keyword::CardLayout& layout = model::contact_card_layout(card);
    const std::array<std::pair<std::string_view, std::string>, 1> zero{
        {{layout.fields.front().name, layout.fields.front().type == keyword::FieldType::integer ? "0" : "0."}}};
    return keyword::card_line(layout, block_->format, zero);
  }

  Status swap(std::string_view card, std::uint32_t line, std::string_view a, std::string_view b) {
    if (line == 0) return {};
    const keyword::CardLayout& layout = model::contact_card_layout(card);
    const std::string one = fields_.written(*block_, line, layout, a), two = fields_.written(*block_, line, layout, b);
    if (one == two) return {};
    if (Status status = fields_.set_text(*block_, line, layout, a, two, true); !status.ok()) return status;
    return fields_.set_text(*block_, line, layout, b, one, true);
  }

  CardFields& fields_;
  const model::Contact& contact_;
  const keyword::Block* block_ = nullptr;
};

/// Puts keywords before *END of the main file, or at its end.
void append_keywords(const keyword::Deck& deck, const std::string& text, DeckEdits& edits) {
  const FileIndex main{0};
  for (const keyword::Block& block : deck.blocks())
    if (block.file == main && block.name == "END") return edits.insert_before(main, block.line, text);
  edits.insert_behind(main, static_cast<std::uint32_t>(edits.lines(main)), text);
}

/// What new keywords of the main file need behind their names, since their cards have the standard format.
std::string_view suffix_of(const keyword::Deck& deck) {
  bool long_fields = false;
  for (const keyword::Block& block : deck.blocks())
    if (block.file == FileIndex{0} && block.name == "KEYWORD")
      long_fields = block.format == keyword::Format::long_fields;
  return long_fields ? "-" : "";
}

/// The largest CEID of the deck.
std::int64_t last_exclusion(const keyword::Deck& deck) {
  std::int64_t last = 0;
  Diagnostics ignored;
  for (const keyword::Block& block : deck.blocks()) {
    if (!block.name.starts_with(model::exclusion_keyword)) continue;
    keyword::CardReader reader(deck, block, ignored);
    last = std::max(last, reader.next(keyword::card_layout(model::exclusion_keyword, "card1")).integer("ceid"));
  }
  return last;
}

std::string exclusion(std::int64_t id, const RepairParts& parts, std::string_view suffix) {
  return fmt::format(
      "*{}{}\n$     CEID       CID\n{:>10}{:>10}\n$     SIDA      SIDB     TYPEA     TYPEB\n{:>10}{:>10}         3     "
      "  "
      "  3",
      model::exclusion_keyword, suffix, id, parts.contact, parts.a, parts.b);
}

/// With an offset, so that rigid parts and parts that do not touch may be joined.
std::string tied_contact(std::int64_t id, const RepairParts& parts, bool solids, std::string_view suffix) {
  const std::string keyword = solids ? model::recommended_keyword(model::ContactCode::tied_surface)
                                           .append(model::suffix(model::TieOffset::penalty))
                                     : model::recommended_keyword(model::ContactCode::tied_shell_edge)
                                           .append(model::suffix(model::TieOffset::beam));
  return fmt::format(
      "{}_ID{}\n{:>10} part {} tied to part {}\n$    SURFA     SURFB  SURFATYP  SURFBTYP\n"
      "{:>10}{:>10}         3         3\n        0.\n        1.",
      keyword, suffix, id, parts.a, parts.b, parts.a, parts.b);
}

/// Keywords that the deck does not have yet.
Status write_keywords(const keyword::Deck& deck, const model::Model& model, const RepairSettings& settings,
                      DeckEdits& edits) {
  std::string text;
  const auto add = [&](const std::string& keyword) { text += (text.empty() ? "" : "\n") + keyword; };
  const std::string_view suffix = suffix_of(deck);
  std::int64_t exclusions = last_exclusion(deck), contacts = 0;
  for (const model::Contact& contact : model.contacts) contacts = std::max(contacts, contact.id.value);
  for (const RepairParts& parts : settings.tied) {
    const auto solid = [&](std::int64_t id) {
      const auto part = model.part_of_id.find(id);
      return part != model.part_of_id.end() && solid_part(model, PartIndex{part->second});
    };
    add(tied_contact(++contacts, parts, solid(parts.a) && solid(parts.b), suffix));
  }
  std::set<RepairParts> excluded = settings.excluded;
  excluded.insert(settings.tied.begin(), settings.tied.end());
  for (const RepairParts& parts : excluded) add(exclusion(++exclusions, parts, suffix));
  if (text.empty()) return {};
  constexpr std::int64_t largest = 9'999'999'999;  // of ten columns
  if (exclusions > largest || contacts > largest) return plain_error("no id is left for a new keyword");
  if (Status status = edits.check(FileIndex{0}); !status.ok()) return status;
  append_keywords(deck, text, edits);
  return {};
}

}  // namespace

Status write_cards(const keyword::Deck& deck, const model::Model& model, const RepairSettings& settings,
                   DeckEdits& edits) {
  CardFields fields(deck, edits);
  const auto cards = [&](std::uint32_t position) {
    return ContactCards(fields, model.contact(ContactIndex{position}));
  };
  for (const std::uint32_t contact : settings.swapped)
    if (Status status = cards(contact).swap(); !status.ok()) return status;
  for (const auto& [contact, thickness] : settings.contact_thickness)
    if (Status status = cards(contact).thickness(thickness); !status.ok()) return status;
  for (const std::uint32_t contact : settings.ignore)
    if (Status status = cards(contact).ignore(settings.contact_thickness.contains(contact)); !status.ok())
      return status;
  if (Status status = write_part_thickness(fields, model, settings.part_thickness); !status.ok()) return status;
  if (Status status = write_section_thickness(fields, model, settings.section_thickness); !status.ok()) return status;
  return write_keywords(deck, model, settings, edits);
}

}  // namespace gapcheck::audit
