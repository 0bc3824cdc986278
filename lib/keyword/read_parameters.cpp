#include <cmath>
#include <limits>

#include "base/number.hpp"
#include "keyword/deck_reader.hpp"

namespace gapcheck::keyword {
namespace {

/// Reads the definitions of one *PARAMETER block. Each is visible to the following ones of the same block.
class ParameterBlock {
 public:
  ParameterBlock(const Deck& deck, Parameters& parameters, const Block& block, Diagnostics& diagnostics)
      : parameters_(parameters), block_(block), reader_(deck, block_, diagnostics), diagnostics_(diagnostics) {
    ++block_.order;
    scope_ = block.name.find("_LOCAL") != std::string::npos ? block.scope : Parameters::global;
  }

  void read_pairs(std::size_t pairs) {
    const CardLayout& layout = card_layout("PARAMETER", "card1");
    while (!reader_.at_end()) {
      const Card card = reader_.next(layout);
      for (std::size_t i = 0; i < pairs; ++i) read_pair(card, 2 * i, 2 * i + 1);
    }
  }

  void read_expressions() {
    const CardLayout& layout = card_layout("PARAMETER_EXPRESSION", "card1");
    while (!reader_.at_end()) {
      const Card card = reader_.next(layout);
      const auto [type, name] = split(card, 0);
      if (name.empty()) continue;
      if (type == 'C') {
        define(card, name, std::string(card.text(1)));
        continue;
      }
      Parameters::Missing missing;
      const auto value = parameters_.evaluate(card.text(1), block_.scope, block_.order, &missing);
      if (value) {
        define_number(card, type, name, value.value());
        continue;
      }
      if (missing.name.empty())
        report(card, value.error().message);
      else if (!missing.told)
        report_missing_parameter(missing.name, reader_.file(), card.line(), "*" + block_.name, diagnostics_);
      if (!missing.name.empty()) define(card, name, Parameters::unknown());
    }
  }

 private:
  /// Type letter and name; an empty name if there is none.
  std::pair<char, std::string_view> split(const Card& card, std::size_t field) {
    const auto text = card.text(field);
    if (text.empty()) return {'\0', {}};
    const char type = static_cast<char>(text.front() & ~0x20);
    const auto name = trimmed(text.substr(1));
    if ((type == 'R' || type == 'I' || type == 'C') && !name.empty()) return {type, name};
    report(card, "\"" + std::string(text) + "\": the name of a parameter starts with its type: R, I or C");
    return {'\0', {}};
  }

  void read_pair(const Card& card, std::size_t name_field, std::size_t value_field) {
    const auto [type, name] = split(card, name_field);
    if (name.empty()) return;
    if (card.blank(value_field))
      report(card, "the parameter \"" + std::string(name) + "\" has no value");
    else if (type == 'C')
      define(card, name, std::string(card.text(value_field)));
    else
      define_field(card, type, name, value_field);
  }

  /// A value that could not be read has been reported, and what uses it says nothing more.
  void define_field(const Card& card, char type, std::string_view name, std::size_t field) {
    constexpr std::int64_t lowest = std::numeric_limits<std::int64_t>::min();
    const double unread = std::numeric_limits<double>::quiet_NaN();
    const std::int64_t integer = type == 'I' ? card.integer(field, lowest) : 0;
    const double real = type == 'I' ? 0 : card.real(field, unread);
    if (integer == lowest || std::isnan(real))
      define(card, name, Parameters::unknown());
    else
      define(card, name, type == 'I' ? ParameterValue(integer) : ParameterValue(real));
  }

  void define_number(const Card& card, char type, std::string_view name, double value) {
    if (type == 'R') return define(card, name, value);
    if (std::abs(value) > 9.0e15) return report(card, "the value of an integer parameter is too large");
    // Sums of decimals miss whole numbers by rounding; everything else is truncated as in an assignment to an integer.
    const double nearest = std::round(value);
    const bool is_whole = std::abs(value - nearest) <= 1e-9 * std::max(1.0, std::abs(value));
    define(card, name, static_cast<std::int64_t>(is_whole ? nearest : std::trunc(value)));
  }

  void define(const Card& card, std::string_view name, ParameterValue value) {
    if (parameters_.define(name, std::move(value), scope_, block_.order - 1)) return;
    report(card, "the parameter \"" + std::string(name) + "\" is " +
                     "a number (for type I a whole one), which the value of --param is not" +
                     "; the value of the deck is used");
  }

  void report(const Card& card, const std::string& problem) {
    diagnostics_.error(reader_.file(), card.line(), "*" + block_.name + ": " + problem);
  }

  Parameters& parameters_;
  Block block_;
  CardReader reader_;
  Diagnostics& diagnostics_;
  std::uint32_t scope_ = Parameters::global;
};

}  // namespace

void DeckReader::read_parameters(const Block& block) {
  if (block.name == "PARAMETER_DUPLICATION") return;  // of several definitions the last one before a use counts
  ParameterBlock reader(deck_, deck_.parameters_, block, diagnostics_);
  if (block.name.starts_with("PARAMETER_EXPRESSION"))
    reader.read_expressions();
  else
    reader.read_pairs(block.name == "PARAMETER_TYPE" ? 1 : 4);
}

}  // namespace gapcheck::keyword
