#pragma once
#include <cstdint>
#include <optional>
#include <string_view>

#include "results/log/log_collector.hpp"
#include "results/text/lines.hpp"

namespace gapcheck::results {

/// What d3hsp (and messag) say about the contact definitions: the echo of each, the "Contact summary" table, the
/// surface time steps, the rows of the timing table. A function that takes lines leaves them at the first line after
/// its text; the others read one line. All get the line's text without leading and trailing blanks.
class ContactEcho {
 public:
  explicit ContactEcho(LogCollector& collector) : collector_(collector) {}

  /// "Contact Interface  80085", a blank line, the title or a blank line.
  bool interface_heading(Lines& lines, std::string_view text);
  /// "contact type...... 2" and the like, of the last heading.
  bool echo_line(std::string_view text);
  /// "Contact summary" and the table below it.
  bool summary(Lines& lines, std::string_view text);
  /// "surfa surface of interface   = 80086" and the lines below it.
  bool surface_timestep(Lines& lines, std::string_view text);
  /// "Interf. ID     80085 8.0486E-04    0.01 ...".
  bool timing_row(std::string_view text);

 private:
  bool summary_row(std::string_view line);

  LogCollector& collector_;
  std::optional<std::uint32_t> current_;
  std::uint32_t headings_ = 0;
};

}  // namespace gapcheck::results
