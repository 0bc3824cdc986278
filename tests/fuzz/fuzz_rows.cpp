// The rows of a mesh read fast, against the same rows card by card and their numbers by the C library. The first two
// characters choose card and format.
#include <array>
#include <bit>
#include <string>
#include <utility>

#include "fuzz.hpp"
#include "keyword/slow_twins.hpp"
#include "keyword/text/fixed_field.hpp"

namespace gapcheck::fuzz::rows_target {
namespace {

constexpr std::array<std::pair<const char*, const char*>, 6> cards{{{"NODE", "card1"},
                                                                    {"ELEMENT_SHELL", "card1"},
                                                                    {"ELEMENT_BEAM", "card1"},
                                                                    {"ELEMENT_DISCRETE", "card1"},
                                                                    {"CONTACT", "C"},
                                                                    {"ELEMENT_SOLID", "card2"}}};
constexpr std::array formats{"", "%", "+"};

std::string text_of(const Diagnostics& diagnostics) {
  std::string text;
  for (const Diagnostic& each : diagnostics.sorted()) text += std::to_string(each.line) + each.message + '\n';
  return text;
}

void rows_are_the_same(std::string text, const keyword::CardLayout& layout) {
  Diagnostics reading, fast_reports, slow_reports;
  keyword::ReadOptions options;
  options.max_include_depth = 0;
  const auto deck = keyword::read_deck_text(std::move(text), "fuzz.k", options, reading);
  if (!deck) return;
  for (const keyword::Block& block : deck.value().blocks()) {
    if (block.name != "NODE") continue;
    const keyword::Rows fast = read_rows(deck.value(), block, layout, fast_reports);
    const keyword::Rows slow = read_by_card(deck.value(), block, layout, slow_reports);
    require(fast.count == slow.count && fast.lines == slow.lines && fast.integers == slow.integers);
    require(fast.reals == slow.reals);
    require(text_of(fast_reports) == text_of(slow_reports));
  }
}

/// All fields of 8, 10, 16 and 20 columns of the lines.
void numbers_are_the_same(std::string_view rows) {
  for (const std::size_t width : {8, 10, 16, 20})
    for (std::size_t at = keyword::reach; at + width + keyword::reach <= rows.size() && at < 400; at += 7) {
      const std::string field(rows.substr(at, width));
      double value = 0;
      if (keyword::read_fixed_real(rows.data() + at, width, value))
        require(std::bit_cast<std::uint64_t>(value) == std::bit_cast<std::uint64_t>(keyword::by_strtod(field)));
      std::int64_t whole = 0;
      if (keyword::read_fixed_integer(rows.data() + at, width, whole))
        require(whole == std::strtoll(field.c_str(), nullptr, 10));
    }
}

}  // namespace

GAPCHECK_FUZZ_TARGET(rows) {
  if (input.size() < 2) return;
  const auto& [keyword, card] = cards[static_cast<unsigned char>(input[0]) % cards.size()];
  const char* format = formats[static_cast<unsigned char>(input[1]) % formats.size()];
  input.remove_prefix(2);
  rows_are_the_same("*PARAMETER\nR p       5\n*NODE" + std::string(format) + "\n" + std::string(input),
                    keyword::card_layout(keyword, card));
  numbers_are_the_same(input);
}

}  // namespace gapcheck::fuzz::rows_target
