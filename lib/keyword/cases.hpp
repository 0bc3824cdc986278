#pragma once
#include <cstdint>
#include <map>
#include <set>
#include <string_view>
#include <vector>

#include "keyword/deck.hpp"

namespace gapcheck::keyword {

/// A line of a file of the deck.
struct FileLine {
  FileIndex file;
  std::uint32_t line = 0;
};

/// The n of a keyword *CASE_BEGIN_n; 0: it is another one.
[[nodiscard]] std::int64_t case_begun(std::string_view name);

/// The n of a file that the run of *CASE n writes, which is named casen.dynain.lsda and the like; 0: it has another
/// name, or that case is not in `begun`.
[[nodiscard]] std::int64_t case_that_writes(std::string_view file, const std::set<std::int64_t>& begun);

/// Which *CASEs a line of the deck belongs to: *CASE_BEGIN_n to *CASE_END_n in the order of the input, which may
/// overlap (*CASE). A run has one case, and what is outside of all.
class Cases {
 public:
  explicit Cases(const Deck& deck);
  /// True if no run has both places, because their cases differ.
  [[nodiscard]] bool never_together(FileLine a, FileLine b) const;

 private:
  using Numbers = std::vector<std::int64_t>;  ///< of the cases, ascending; empty: every run has it
  struct Start {
    std::uint32_t line;
    Numbers cases;
  };
  [[nodiscard]] const Numbers& at(FileLine place) const;

  std::map<std::uint32_t, std::vector<Start>> of_file_;  ///< by file; where the cases change, ascending
};

}  // namespace gapcheck::keyword
