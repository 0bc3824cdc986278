#pragma once
#include <string>
#include <string_view>

#include "results/log/log_collector.hpp"
#include "results/text/lines.hpp"

namespace gapcheck::results {

/// Reads what the files say about the whole run: banner, version stamp and title, precision, ranks, termination, time
/// and cycles, the smallest element time steps. Lines as in ContactEcho.
class RunFacts {
 public:
  explicit RunFacts(LogCollector& collector) : collector_(collector), run_(collector.run()) {}

  /// "|  Version : smp d R14   |".
  bool banner_line(std::string_view text);
  /// "ls-dyna smp d R14 R14.0_515_8a12796 date 12/12/2022"; the line before it is the title.
  bool version_stamp(std::string_view text, std::string_view line_before);
  /// "N o r m a l    t e r m i n a t i o n", "E r r o r   t e r m i n a t i o n".
  bool termination(std::string_view text);
  /// "9 t 1.0000E-01 dt 0.00E+00 write d3plot file", "Problem time = ...", "Problem cycle = ...".
  bool cycle_line(std::string_view text);
  bool problem_line(std::string_view text);
  /// "termination time...............................    0.2400E+03", as a d3hsp echoes it.
  bool end_time(std::string_view text);
  /// "The LS-DYNA time step size should not exceed     3.179E-04".
  bool contact_limit(std::string_view text, std::uint32_t line);
  /// "100 smallest timesteps" and the table below it.
  bool smallest_timesteps(Lines& lines, std::string_view text);
  /// "MPP execution with 8 procs".
  bool ranks(std::string_view text);

 private:
  LogCollector& collector_;
  SolverRun& run_;
};

}  // namespace gapcheck::results
