#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/result.hpp"
#include "keyword/deck.hpp"
#include "keyword/write_back.hpp"
#include "model/model.hpp"

namespace gapcheck::audit {

/// The lines of *NODE that hold a model's coordinates: their text for other coordinates, and the node's position when
/// that is read back. Deck, model and coordinates must outlive it. Not for use from several threads.
class NodeLines {
 public:
  /// `x`: the deck's coordinates by node, whatever the model holds by now.
  NodeLines(const keyword::Deck& deck, const model::Model& model, const std::vector<Vector>& x);
  /// Whether a node's coordinates can be rewritten.
  [[nodiscard]] Status check(NodeIndex node);
  /// Where the node lies when `to` (in the model's system) is written into its line: the nearest position that the
  /// line's format can express, through the placement of its include. Directions in which it does not move, except for
  /// rounding, keep their digits. As in the deck if the line cannot be rewritten.
  [[nodiscard]] Vector written(NodeIndex node, const Vector& to);
  /// Its line with those coordinates.
  [[nodiscard]] keyword::LineEdit edit(NodeIndex node, const Vector& to);

 private:
  /// A line and the block that it belongs to.
  struct Place {
    const keyword::Block* block = nullptr;
    std::string_view line;
    std::uint32_t number = 0;
  };
  [[nodiscard]] Place place(NodeIndex node);
  [[nodiscard]] const keyword::LineIndex& lines(FileIndex file);
  [[nodiscard]] const keyword::Block* block_at(FileIndex file, std::uint32_t line) const;
  [[nodiscard]] keyword::Card card(const Place& place, std::string_view line);
  void find_duplicates();

  const keyword::Deck& deck_;
  const model::Model& model_;
  const std::vector<Vector>& x_;
  const keyword::CardLayout layout_;
  Diagnostics ignored_;                                     ///< already reported when the deck was read
  std::vector<std::vector<const keyword::Block*>> blocks_;  ///< by file, ascending by line
  std::vector<bool> read_twice_;                            ///< by file: each line represents several nodes
  std::map<std::uint32_t, keyword::LineIndex> lines_;       ///< by file
  std::unordered_map<std::int64_t, bool> again_;            ///< ids that are defined more than once
};

/// The lines of one file of a deck that change.
struct ChangedLines {
  FileIndex file;
  std::vector<keyword::LineEdit> edits;  ///< ascending by line
};

/// An error if the deck has a keyword that moves nodes away from where their lines say, or that moves or creates some
/// and is not read, or lacks an include: changed lines would not be the geometry that runs.
[[nodiscard]] Status check_geometry(const keyword::Deck& deck);

/// The lines of *NODE with other coordinates.
struct MovedDeck {
  std::vector<ChangedLines> files;  ///< only those that change, in the order of the deck
  std::uint64_t nodes = 0;          ///< whose lines change
  double rounding = 0;              ///< largest distance between a node and what its line can express
};

/// Writes `x` (coordinates by node) into the lines of the nodes that are not where the deck has them; all other lines
/// stay. Errors: check_geometry(), and a node whose line cannot be rewritten.
[[nodiscard]] Result<MovedDeck> move_deck(const keyword::Deck& deck, const model::Model& model,
                                          const std::vector<Vector>& x);

}  // namespace gapcheck::audit
