#pragma once
#include <cstdint>
#include <string_view>

#include "results/log/log_collector.hpp"
#include "results/text/lines.hpp"

namespace gapcheck::results {

/// Lines of penetrations outside of message blocks, as MPP ranks and mortar contacts print them. Lines as in
/// ContactEcho.
class NodeLines {
 public:
  explicit NodeLines(LogCollector& collector) : collector_(collector) {}

  /// "12 initial penetrations were found for interface          2".
  bool count_line(std::string_view text);
  /// "Summary of warning messages for interface # = 2" and the count below it.
  bool warning_summary(Lines& lines, std::string_view text);
  /// "summary of initial penetration for interface #= 1" and the counts and depths below it (SMP).
  bool initial_summary(Lines& lines, std::string_view text);
  /// "Contact sliding interface 1010" and the lines of a mortar contact below it.
  bool mortar(Lines& lines, std::string_view text);
  /// Anything with "Moved node", "has penetration" or, outside of a d3hsp's echo, "penetrat": ids and numbers are taken
  /// from the line; a line without them is listed.
  bool node_line(const Lines& lines, std::string_view text);

 private:
  bool record(std::string_view text, std::uint32_t line, bool moved);
  void list(std::string_view text, std::uint32_t line, const std::string& kind, Severity severity);

  LogCollector& collector_;
  std::int64_t interface_ = 0;  ///< the last one that a line named
};

}  // namespace gapcheck::results
