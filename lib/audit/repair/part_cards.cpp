#include "audit/repair/part_cards.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include "keyword/upper_case.hpp"

namespace gapcheck::audit {
namespace {

constexpr std::string_view plain_part = "PART", contact_part = "PART_CONTACT";

const keyword::CardLayout& contact_card() { return keyword::card_layout(contact_part, "card3"); }

/// A keyword line with another name; what follows the name stays.
std::string with_name(std::string_view line, std::string_view name) {
  std::size_t end = std::min(line.find_first_of(" \t"), line.size());
  if (end > 1 && std::string_view("+-%").find(line[end - 1]) != std::string_view::npos) --end;
  return fmt::format("*{}{}", name, line.substr(end));
}

/// The lines of a part in its block.
struct PartLines {
  std::uint32_t heading = 0, card = 0;
};

/// All parts of a block of *PART or *PART_CONTACT, which has one card more.
std::vector<PartLines> lines_of_parts(const keyword::Deck& deck, const keyword::Block& block,
                                      const std::set<std::uint32_t>& cards) {
  Diagnostics ignored;
  keyword::CardReader reader(deck, block, ignored);
  std::vector<PartLines> parts;
  std::uint32_t before = 0;
  for (; !reader.at_end(); reader.skip()) {
    const std::uint32_t line = reader.peek_line();
    if (cards.contains(line)) parts.push_back({before, line});
    before = line;
  }
  return parts;
}

/// OPTT of the parts of one block, by the line of their card.
class PartBlock {
 public:
  PartBlock(CardFields& fields, const model::Model& model, const keyword::Block& block)
      : fields_(fields), block_(block) {
    for (const model::Part& part : model.parts)
      if (part.place.file == block.file) cards_.insert(part.place.line);
  }

  Status write(const std::map<std::uint32_t, double>& thickness) {
    if (const Status status = fields_.check(block_); !status.ok()) return status;
    const std::vector<PartLines> parts = lines_of_parts(fields_.deck(), block_, cards_);
    if (block_.name == contact_part) return in_their_cards(parts, thickness);
    if (block_.name == plain_part) return with_new_cards(parts, thickness);
    return fields_.error({block_.file, block_.line}, fmt::format("OPTT of *{} has to be written by hand", block_.name));
  }

 private:
  Status in_their_cards(const std::vector<PartLines>& parts, const std::map<std::uint32_t, double>& thickness) {
    Diagnostics ignored;
    keyword::CardReader reader(fields_.deck(), block_, ignored);
    for (const PartLines& part : parts) {
      const auto value = thickness.find(part.card);
      if (value == thickness.end()) continue;
      while (!reader.at_end() && reader.peek_line() <= part.card) reader.skip();
      if (reader.at_end()) return fields_.error({block_.file, part.card}, "the part's contact card is missing");
      if (Status status = fields_.set(block_, reader.peek_line(), contact_card(), "optt", value->second); !status.ok())
        return status;
    }
    return {};
  }

  /// The keyword line is repeated where parts with and without the option follow each other.
  Status with_new_cards(const std::vector<PartLines>& parts, const std::map<std::uint32_t, double>& thickness) {
    const std::string plain(fields_.edits().line(block_.file, block_.line));
    const std::string with_option = with_name(plain, contact_part);
    bool option = false;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const auto value = thickness.find(parts[i].card);
      const bool wanted = value != thickness.end();
      if (i == 0 && wanted) fields_.edits().replace(block_.file, block_.line, with_option);
      if (i > 0 && wanted != option)
        fields_.edits().insert_before(block_.file, parts[i].heading, wanted ? with_option : plain);
      option = wanted;
      if (!wanted) continue;
      const std::array<std::pair<std::string_view, double>, 1> card{{{"optt", value->second}}};
      fields_.edits().insert_behind(block_.file, parts[i].card, CardFields::card(block_, contact_card(), card));
    }
    return {};
  }

  CardFields& fields_;
  const keyword::Block& block_;
  std::set<std::uint32_t> cards_;  ///< lines of all parts of the file, also of those in other blocks
};

/// The line behind one of a block; 0: there is none.
std::uint32_t line_behind(const keyword::Deck& deck, const keyword::Block& block, std::uint32_t line) {
  Diagnostics ignored;
  keyword::CardReader reader(deck, block, ignored);
  while (!reader.at_end() && reader.peek_line() <= line) reader.skip();
  return reader.at_end() ? 0 : reader.peek_line();
}

}  // namespace

Status write_part_thickness(CardFields& fields, const model::Model& model,
                            const std::map<std::int64_t, double>& thickness) {
  std::map<const keyword::Block*, std::map<std::uint32_t, double>> blocks;
  for (const auto& [id, value] : thickness) {
    const auto part = model.part_of_id.find(id);
    const keyword::Block* block =
        part == model.part_of_id.end() ? nullptr : fields.block(model.part(part->second).place);
    if (block == nullptr) return plain_error(fmt::format("the card of part {} was not found", id));
    blocks[block].emplace(model.part(part->second).place.line, value);
  }
  for (const auto& [block, lines] : blocks)
    if (Status status = PartBlock(fields, model, *block).write(lines); !status.ok()) return status;
  return {};
}

Status write_section_thickness(CardFields& fields, const model::Model& model,
                               const std::map<std::int64_t, double>& thickness) {
  const keyword::CardLayout& layout = keyword::card_layout("SECTION_SHELL", "card2");
  for (const auto& [id, value] : thickness) {
    const auto section = std::find_if(model.sections.begin(), model.sections.end(),
                                      [id = id](const model::Section& each) { return each.id == id; });
    const keyword::Block* block = section == model.sections.end() ? nullptr : fields.block(section->place);
    if (block == nullptr || !block->name.starts_with("SECTION_SHELL"))
      return plain_error(fmt::format("the card of section {} was not found", id));
    if (Status status = fields.check(*block); !status.ok()) return status;
    const std::uint32_t line = line_behind(fields.deck(), *block, section->place.line);
    if (line == 0) return fields.error(section->place, "the section's thickness card is missing");
    for (const std::string_view field : {"t1", "t2", "t3", "t4"}) {
      // Blank ones repeat T1.
      if (field != "t1" && fields.written(*block, line, layout, field).empty()) continue;
      if (Status status = fields.set(*block, line, layout, field, value); !status.ok()) return status;
    }
  }
  return {};
}

}  // namespace gapcheck::audit
