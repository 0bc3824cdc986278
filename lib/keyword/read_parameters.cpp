#include <cmath>
#include <limits>

#include "base/number.hpp"
#include "keyword/deck_reader.hpp"
#include "keyword/upper_case.hpp"

namespace gapcheck::keyword {
namespace {

/// Reads the definitions of one *PARAMETER block. Each is visible to the following ones of the same block.
class ParameterBlock {
 public:
  ParameterBlock(const Deck& deck, Parameters& parameters, ParameterDuplicates& duplicates, const Block& block,
                 Diagnostics& diagnostics)
      : parameters_(parameters),
        duplicates_(duplicates),
        block_(block),
        reader_(deck, block_, diagnostics),
        diagnostics_(diagnostics) {
    ++block_.order;
    mutable_ = block.name.find("_MUTABLE") != std::string::npos;
    scope_ = block.name.find("_LOCAL") != std::string::npos ? block.scope : Parameters::global;
  }

  void read() {
    if (block_.name == "PARAMETER_DUPLICATION")
      read_duplication();
    else if (block_.name.starts_with("PARAMETER_EXPRESSION"))
      read_expressions();
    else
      read_pairs(block_.name == "PARAMETER_TYPE" ? 1 : 4);
  }

 private:
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
      const bool nameless = card.text(0).empty();
      const auto [type, name] = split(card, 0);
      std::string text(card.text(1));
      if (nameless && !text.empty()) report(card, "the line continues an expression, but there is none before it");
      // Lines without a name continue the expression.
      while (!reader_.at_end() && reader_.peek(layout).text(0).empty()) text += reader_.next(layout).text(1);
      if (!name.empty()) define_expression(card, type, name, text);
    }
  }

  /// *PARAMETER_DUPLICATION: holds from here on.
  void read_duplication() {
    const CardLayout& layout = card_layout("PARAMETER_DUPLICATION", "card1");
    while (!reader_.at_end()) {
      const Card card = reader_.next(layout);
      const std::int64_t flag = card.integer(0);
      if (flag < 0 || flag > 5)
        report(card, "DFLAG = " + std::to_string(flag) + " is not one of 1 to 5");
      else
        duplicates_.flag = flag == 0 ? 1 : flag;
    }
  }

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

  void define_expression(const Card& card, char type, std::string_view name, const std::string& text) {
    if (type == 'C') return define(card, name, text);
    Parameters::Missing missing;
    const auto value = parameters_.evaluate(text, block_.scope, block_.order, &missing);
    if (value) return define_number(card, type, name, value.value());
    if (missing.name.empty())
      report(card, value.error().message);
    else if (!missing.told)
      report_missing_parameter(missing.name, reader_.file(), card.line(), "*" + block_.name, diagnostics_);
    if (!missing.name.empty()) define(card, name, Parameters::unknown());
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
    if (keeps_first(card, name, value)) return;
    if (parameters_.define(name, std::move(value), scope_, block_.order - 1)) return;
    report(card, "the parameter \"" + std::string(name) + "\" is " +
                     "a number (for type I a whole one), which the value of --param is not" +
                     "; the value of the deck is used");
  }

  /// Whether the name has a value in this scope that the new one does not replace. A warning if they differ, or an
  /// error.
  bool keeps_first(const Card& card, std::string_view name, const ParameterValue& value) {
    const auto [found, is_new] = duplicates_.defined.try_emplace({upper_case(name), scope_}, mutable_);
    if (is_new || found->second) return false;
    const std::int64_t flag = duplicates_.flag;
    const bool keeps = flag != 2 && flag != 4;
    const ParameterValue* first = parameters_.find(name, scope_, block_.order);
    if (flag > 3 || first == nullptr || *first == value || Parameters::is_unknown(*first) ||
        Parameters::is_unknown(value) || parameters_.given(name) != nullptr)
      return keeps;
    const std::string problem = "the parameter \"" + std::string(name) + "\" is defined again with another value; ";
    if (flag == 3)
      report(card, problem + "DFLAG = 3 of *PARAMETER_DUPLICATION forbids it");
    else
      diagnostics_.warning(
          reader_.file(), card.line(),
          "*" + block_.name + ": " + problem +
              (keeps ? "the first value counts, as in LS-DYNA; remove one definition, or make the first "
                       "one *PARAMETER_MUTABLE"
                     : "the new value counts (DFLAG = 2 of *PARAMETER_DUPLICATION)"));
    return keeps;
  }

  void report(const Card& card, const std::string& problem) {
    diagnostics_.error(reader_.file(), card.line(), "*" + block_.name + ": " + problem);
  }

  Parameters& parameters_;
  ParameterDuplicates& duplicates_;
  Block block_;
  CardReader reader_;
  Diagnostics& diagnostics_;
  std::uint32_t scope_ = Parameters::global;
  bool mutable_ = false;
};

}  // namespace

void DeckReader::read_parameters(const Block& block) {
  ParameterBlock(deck_, deck_.parameters_, duplicates_, block, diagnostics_).read();
}

}  // namespace gapcheck::keyword
