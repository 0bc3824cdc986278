#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace gapcheck::keyword {

/// The rows of a block that repeats one card, as columns of numbers.
struct Rows {
  std::size_t count = 0;
  std::size_t integer_columns = 0, real_columns = 0;
  std::vector<std::int64_t> integers;  ///< count x integer_columns, row by row; blank = 0
  std::vector<double> reals;           ///< count x real_columns, row by row; blank = 0
  std::vector<std::uint32_t> lines;    ///< count
};

/// A field of a row in the text, and what is added to the ids in it.
struct RowColumn {
  std::size_t begin = 0, width = 0;
  std::int64_t offset = 0;
  friend auto operator<=>(const RowColumn&, const RowColumn&) = default;
};

/// The rows of a block as numbers, in pieces as they were read.
struct RowTable {
  struct Piece {
    std::size_t first = 0;  ///< position of its first row in the block
    std::shared_ptr<const Rows> rows;
  };
  std::size_t count = 0;
  std::vector<Piece> pieces;
};

/// Tables of the blocks of one file, for later decks that include it: each is read from the text only once. Not for use
/// by two threads at a time.
class KeptRows {
 public:
  /// What the numbers depend on, besides the text of the file.
  struct Key {
    std::size_t position = 0;  ///< of the block's body in the file
    std::vector<RowColumn> integers, reals;
    friend auto operator<=>(const Key&, const Key&) = default;
  };
  /// `left`: how many bytes all files may still keep; shared by the files of a cache. None: nothing is kept.
  explicit KeptRows(std::shared_ptr<std::uint64_t> left = nullptr) : left_(std::move(left)) {}
  [[nodiscard]] bool keeps() const { return left_ != nullptr && *left_ > 0; }
  /// nullptr: not kept. Valid as long as this.
  [[nodiscard]] const RowTable* find(const Key& key);
  /// Keeps the table unless it is larger than what is left.
  void keep(Key key, RowTable table);
  /// How often find() had a table.
  [[nodiscard]] std::uint64_t used() const { return used_; }

 private:
  std::shared_ptr<std::uint64_t> left_;
  std::map<Key, RowTable> tables_;
  std::uint64_t used_ = 0;
};

}  // namespace gapcheck::keyword
