#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "results/text/file_header.hpp"
#include "results/text/lines.hpp"

namespace gapcheck::results {

/// Iterates over the lines of a result file and records their faults: one diagnostic for each kind of fault, with its
/// first line. A last line without line end is left out: its numbers may be cut. Text, name and diagnostics must
/// outlive it.
class ResultText {
 public:
  ResultText(std::string_view text, const std::string& name, Diagnostics& diagnostics)
      : lines_(text), name_(name), diagnostics_(diagnostics) {
    leave_out_open();
  }

  [[nodiscard]] bool done() const { return lines_.done(); }
  [[nodiscard]] std::string_view line() const { return lines_.line(); }
  void advance();

  /// Takes a number off the front of `rest`. NaN if the run wrote NaN or Infinity, and if it cannot be read
  /// (`********`, nothing), which is a fault.
  double take(std::string_view& rest);
  /// A row that cannot be read as a whole.
  void unreadable();
  /// The state before the current line, or at the end of the file the last one, lacks rows and is left out.
  void incomplete();
  /// If the current line begins a legend, reads its entries up to its last line. False if no legend begins, and if one
  /// has no end, which is a fault: the current line is then the first one after it.
  bool take_legend(std::vector<LegendEntry>& entries);
  /// Reports the faults. Once, at the end.
  void finish();

 private:
  struct Fault {
    std::uint64_t count = 0;
    std::uint32_t first = 0;
    void add(std::uint32_t line) {
      if (count++ == 0) first = line;
    }
  };

  void leave_out_open();

  Lines lines_;
  const std::string& name_;
  Diagnostics& diagnostics_;
  Fault unreadable_, incomplete_, open_legend_, cut_legend_;
  std::uint32_t last_line_ = 0;
  bool open_ = false;
};

}  // namespace gapcheck::results
