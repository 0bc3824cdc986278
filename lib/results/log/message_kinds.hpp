#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/diagnostic.hpp"
#include "records/tie_failure.hpp"
#include "results/log/message_block.hpp"

namespace gapcheck::results {

/// What a block is converted to.
enum class BlockRecord : std::uint8_t { none, penetration, released, tie, rigidwall, cut };

/// One entry of the table of message kinds (message_kinds.txt describes the syntax).
struct MessageKind {
  enum Label : std::uint8_t { contact, node, segment, distance, remaining, label_count };
  std::string name;
  std::vector<std::int64_t> codes;
  std::vector<std::vector<std::string>> words;  ///< one of these, all of its phrases; lower case, single blanks
  bool assumed = false;                         ///< no file at hand shows the message: the words are a guess
  BlockRecord record = BlockRecord::none;
  TieReason reason = TieReason::not_found;
  std::array<std::vector<std::string>, label_count> labels;
  /// The value of the field with this label. If no label matches exactly, case and blanks are ignored, and a label that
  /// ends in "#" also matches after other words, as in joined texts.
  [[nodiscard]] std::optional<Label> label_of(std::string_view label) const;
};

/// The table: entries of a user before the built-in ones, each in the order of its file.
class MessageKinds {
 public:
  /// The built-in table.
  MessageKinds();
  MessageKinds(const MessageKinds&) = delete;
  MessageKinds& operator=(const MessageKinds&) = delete;
  /// Puts the entries of a text before the existing ones. Unreadable entries are reported (error) and skipped.
  void add(std::string_view text, const std::string& file, Diagnostics& diagnostics);
  /// The entry of a block; nullptr: not understood. The pointer is valid until the next add().
  [[nodiscard]] const MessageKind* find(const MessageBlock& block) const;

 private:
  const std::vector<const MessageKind*>& candidates(std::int64_t code) const;

  std::vector<MessageKind> kinds_;
  mutable std::unordered_map<std::int64_t, std::vector<const MessageKind*>> by_code_;
};

}  // namespace gapcheck::results
