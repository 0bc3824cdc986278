#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "lsp/card_order.hpp"
#include "lsp/text.hpp"

namespace gapcheck::app::lsp {

/// What is wrong with a line.
struct LineFault {
  std::uint32_t line = 0;
  std::size_t begin = 0, end = 0;  ///< bytes
  Severity severity = Severity::error;
  std::string message;
};

/// Most faults that are told of one text.
inline constexpr std::size_t most_faults = 1000;

/// Checks a text without its deck: fields that should be numbers, and the names of keywords, in the words of the audit.
/// What was found in a piece of the text is kept, so that the next check only looks at pieces that have changed.
class SyntaxCheck {
 public:
  /// By line.
  [[nodiscard]] std::vector<LineFault> check(const Text& text);
  /// How many pieces the last check looked at.
  [[nodiscard]] std::size_t looked_at() const { return looked_at_; }

 private:
  /// What a piece of text begins with.
  struct State {
    std::string keyword;  ///< empty: none
    keyword::Format format = keyword::Format::standard, of_file = keyword::Format::standard;
    CardOrder order;
    std::size_t row = 0;
    bool ended = false;  ///< behind *END
    bool operator==(const State&) const = default;
  };
  struct Checked {
    State before;
    std::vector<LineFault> faults;  ///< lines count from the piece's first
  };
  [[nodiscard]] static std::vector<State> states(const Text& text);
  [[nodiscard]] static Checked checked(const Text& text, std::size_t piece, const State& before);
  std::map<std::shared_ptr<const Piece>, Checked> known_;
  std::size_t looked_at_ = 0;
};

}  // namespace gapcheck::app::lsp
