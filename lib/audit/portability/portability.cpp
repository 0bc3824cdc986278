#include "audit/portability/portability.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "base/number.hpp"
#include "keyword/card.hpp"
#include "model/contact/contact_cards.hpp"
#include "model/contact/contact_name.hpp"

namespace gapcheck::audit {
namespace {

using keyword::Card;
using keyword::CardReader;

/// Notes of one program, each thing once.
class PortabilityNotes {
 public:
  PortabilityNotes(const keyword::Deck& deck, const OtherProgram& program) : deck_(deck), program_(program) {}

  void add(PortabilityKind kind, std::string name, bool other_meaning, model::Place place, std::string_view source) {
    const auto [entry, is_new] = positions_.try_emplace(std::tuple(kind, name, other_meaning), notes_.size());
    if (!is_new) {
      ++notes_[entry->second].count;
      return;
    }
    notes_.push_back({std::string(program_.name), kind, other_meaning, std::move(name), 1,
                      place.file == none<FileIndex> ? std::string() : deck_.file(place.file).path, place.line,
                      std::string(source)});
  }

  /// By kind; of one kind as they were found.
  [[nodiscard]] std::vector<PortabilityNote> take() {
    std::stable_sort(notes_.begin(), notes_.end(),
                     [](const PortabilityNote& a, const PortabilityNote& b) { return a.kind < b.kind; });
    return std::move(notes_);
  }

 private:
  const keyword::Deck& deck_;
  const OtherProgram& program_;
  std::map<std::tuple<PortabilityKind, std::string, bool>, std::size_t> positions_;
  std::vector<PortabilityNote> notes_;
};

/// The option words of a keyword as the deck writes it: ID and TITLE are the same option, but not for every program.
std::vector<std::string_view> option_words(const model::Contact& contact) {
  std::vector<std::string_view> words;
  const auto written = model::words_of(contact.written);
  const auto has = [&](std::string_view word) {
    return std::find(written.begin(), written.end(), word) != written.end();
  };
  for (const std::string_view word : {"ID", "TITLE"})
    if (has(word)) words.push_back(word);
  const model::ContactOptions& options = contact.options;
  if (options.mpp) words.emplace_back("MPP");
  if (options.mortar) words.emplace_back("MORTAR");
  if (options.smooth) words.emplace_back("SMOOTH");
  if (options.thermal) words.emplace_back(options.thermal_friction ? "THERMAL_FRICTION" : "THERMAL");
  if (options.ortho_friction) words.emplace_back("ORTHO_FRICTION");
  return words;
}

/// Calls visit(card, layout) for each card with fields that all programs could read: cards 1 to 3, the type's own one,
/// A to G. Those of option words are passed over: the option is named.
template <class Visit>
void for_each_card(CardReader& reader, const model::Contact& contact, const Visit& visit) {
  const auto skip = [&](std::size_t lines) {
    for (; lines > 0 && !reader.at_end(); --lines) reader.skip();
  };
  const auto next = [&](const keyword::CardLayout& layout) {
    if (!reader.at_end()) visit(reader.next(layout), layout);
  };
  skip(contact.options.id ? 1 : 0);
  if (contact.options.mpp) {
    skip(1);
    if (trimmed(reader.peek()).starts_with('&')) skip(1);
  }
  for (const std::string_view name : {"card1", "card2", "card3"}) next(model::contact_card_layout(name));
  if (const keyword::CardLayout* own = model::type_card(contact.kind->cards)) next(*own);
  skip((contact.options.thermal ? 1u : 0u) + (contact.options.thermal_friction ? 1u : 0u) +
       (contact.options.ortho_friction ? 4u : 0u));
  for (const std::string_view name : {"A", "B", "C", "D", "E", "F", "G"}) next(model::contact_card_layout(name));
}

double value_of(const Card& card, std::size_t index, const keyword::Field& field) {
  return field.type == keyword::FieldType::real ? card.real(index) : static_cast<double>(card.integer(index));
}

class PortabilityFinder {
 public:
  PortabilityFinder(const keyword::Deck& deck, const PortabilityTable& table) : deck_(deck), table_(table) {
    for (const keyword::Block& block : deck.blocks())
      if (block.name.starts_with("CONTACT")) blocks_.try_emplace({block.file, block.line}, &block);
  }

  void compare(const OtherProgram& program, const model::Contact& contact, PortabilityNotes& notes) const {
    const ReadKind* row = contact.kind == nullptr ? nullptr : program.find(contact.kind->name);
    if (row == nullptr)
      return notes.add(PortabilityKind::keyword, contact.keyword, false, contact.place, program.source);
    for (const std::string_view word : option_words(contact))
      if (std::find(program.options.begin(), program.options.end(), word) == program.options.end())
        notes.add(PortabilityKind::option, std::string(word), false, contact.place, row->source);
    const auto block = blocks_.find({contact.place.file, contact.place.line});
    if (block == blocks_.end()) return;
    Diagnostics reported;  // the reader of the model has named the fields that are not numbers
    CardReader reader(deck_, *block->second, reported);
    for_each_card(reader, contact, [&](const Card& card, const keyword::CardLayout& layout) {
      compare_card(*row, card, layout, contact.place.file, notes);
    });
  }

 private:
  void compare_card(const ReadKind& row, const Card& card, const keyword::CardLayout& layout, FileIndex file,
                    PortabilityNotes& notes) const {
    for (std::size_t i = 0; i < layout.fields.size(); ++i) {
      const keyword::Field& field = layout.fields[i];
      if (field.type == keyword::FieldType::text || field.name == "unused") continue;
      const bool other = contains(row.other_meaning, field.name);
      if (!other && contains(row.fields, field.name)) continue;
      const double value = value_of(card, i, field);
      const auto usual = table_.defaults.find(field.name);
      if (value == 0 || (usual != table_.defaults.end() && value == usual->second)) continue;
      notes.add(PortabilityKind::field, table_.name_of(field.name), other, {file, card.line()}, row.source);
    }
  }

  static bool contains(const std::vector<std::string_view>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  }

  const keyword::Deck& deck_;
  const PortabilityTable& table_;
  std::map<std::pair<FileIndex, std::uint32_t>, const keyword::Block*> blocks_;
};

}  // namespace

Portability find_portability(const keyword::Deck& deck, const model::Model& model,
                             const std::vector<ContactIndex>& contacts, const PortabilityTable& table) {
  Portability result;
  const PortabilityFinder finder(deck, table);
  const bool all = contacts.size() == model.contacts.size();
  for (const OtherProgram& program : table.programs) {
    result.programs.emplace_back(program.name);
    PortabilityNotes notes(deck, program);
    for (const ContactIndex contact : contacts) finder.compare(program, model.contacts[contact.value], notes);
    for (const model::ContactExclusion& exclusion : model.exclusions)
      if (all)
        notes.add(PortabilityKind::keyword, std::string(model::exclusion_keyword), false, exclusion.place,
                  program.source);
    for (PortabilityNote& note : notes.take()) result.notes.push_back(std::move(note));
  }
  return result;
}

}  // namespace gapcheck::audit
