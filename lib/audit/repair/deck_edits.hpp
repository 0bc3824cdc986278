#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "audit/fix/node_lines.hpp"
#include "base/result.hpp"
#include "keyword/deck.hpp"
#include "keyword/write_back.hpp"
#include "records/repair_plan.hpp"

namespace gapcheck::audit {

/// Lines of a deck that change, and lines that are put in beside them. The deck must outlive it. Files of which nothing
/// changes keep every byte.
class DeckEdits {
 public:
  explicit DeckEdits(const keyword::Deck& deck) : deck_(deck) {}

  /// An error if the lines of a file cannot be changed: it is included more than once, and each inclusion would change.
  [[nodiscard]] Status check(FileIndex file) const;
  /// A line, from 1, as changed so far.
  [[nodiscard]] std::string_view line(FileIndex file, std::uint32_t number);
  [[nodiscard]] std::size_t lines(FileIndex file) { return index(file).size(); }
  void replace(FileIndex file, std::uint32_t number, std::string text);
  /// Whole lines, parted by `\n`, before or behind a line; further ones come behind those already there.
  void insert_before(FileIndex file, std::uint32_t number, std::string_view text);
  void insert_behind(FileIndex file, std::uint32_t number, std::string_view text);

  /// The changes, by file in the order of the deck.
  [[nodiscard]] std::vector<ChangedLines> changed() const;
  /// The same for a report.
  [[nodiscard]] std::vector<RepairLine> listed();
  /// Forgets the changes.
  void clear() { files_.clear(); }

 private:
  struct Change {
    std::string before, text, behind;
  };
  [[nodiscard]] const keyword::LineIndex& index(FileIndex file);
  [[nodiscard]] Change& change(FileIndex file, std::uint32_t number);

  const keyword::Deck& deck_;
  std::map<std::uint32_t, keyword::LineIndex> index_;               ///< by file
  std::map<std::uint32_t, std::map<std::uint32_t, Change>> files_;  ///< by file and line
};

/// The text of each file that changes, by its path as read.
[[nodiscard]] std::map<std::string, std::string> changed_texts(const keyword::Deck& deck,
                                                               std::span<const ChangedLines> files);

/// Gives lines that repairs add the line ends of their files, as they are written: for those who put texts in as they
/// are.
void take_line_ends(const keyword::Deck& deck, RepairPlan& plan);

}  // namespace gapcheck::audit
