#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "records/solver_run.hpp"

namespace gapcheck::results {

/// The messages that are not records. For each number and kind the first texts are kept, the rest are counted. The same
/// text in several files (ranks, messag and d3hsp) is one message, counted as often as in the file that has it most
/// often.
class MessageLog {
 public:
  static constexpr std::size_t kept_texts = 20;
  /// Bytes kept of one text; the caller cuts it.
  static constexpr std::size_t longest_text = 2000;

  /// True if the text of a message with this hash should be passed to keep(); it is counted in any case.
  bool count(Severity severity, std::int64_t code, const std::string& kind, std::uint64_t hash, std::uint32_t file);
  /// Only if count() returned true.
  void keep(SolverMessage message);

  /// How often the current file has printed the number, to detect whether a limit cut them.
  void count_block(std::int64_t code);
  void begin_file() { blocks_.clear(); }
  /// True if a number was printed exactly `limit` times in the current file.
  [[nodiscard]] bool any_block_counted(std::uint64_t limit) const;

  /// By code, then file and line; ends the log.
  [[nodiscard]] std::vector<SolverMessage> take();

 private:
  struct Tally {
    std::uint64_t most = 0, in_file = 0;
    std::uint32_t file = 0, position = 0;  ///< position in Group::kept; kept_texts: not kept
    void add(std::uint32_t in) {
      in_file = in == file ? in_file + 1 : 1;
      file = in;
      most = in_file > most ? in_file : most;
    }
  };
  struct Group {
    std::vector<SolverMessage> kept;
    std::unordered_map<std::uint64_t, Tally> texts;
    Tally overflow;  ///< texts beyond those distinguished
    std::uint32_t file = 0, line = 0;
  };
  using Key = std::tuple<std::int64_t, Severity, std::string>;

  std::map<Key, Group> groups_;
  Group* last_ = nullptr;
  std::size_t texts_ = 0;
  std::unordered_map<std::int64_t, std::uint64_t> blocks_;
};

}  // namespace gapcheck::results
