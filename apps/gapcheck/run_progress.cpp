#include "run_progress.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

#include "base/system/terminal.hpp"

namespace gapcheck::app {

std::string duration(double seconds) {
  if (!(seconds < 1e9)) return "long";
  const auto whole = static_cast<long>(std::lround(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

RunProgress::RunProgress(bool wanted) : wanted_(wanted && system::obeys_escapes(system::standard_error)) {}

RunProgress::~RunProgress() {
  if (shown_) std::fputs("\r\x1b[K", stderr);
}

void RunProgress::show(const solver::Run& run) {
  if (!wanted_) return;
  const double seconds = run.seconds();
  if (seconds - last_ < 0.5) return;
  last_ = seconds;
  shown_ = true;
  const solver::Stepper& stepper = run.stepper();
  const double time = stepper.state().time, end = run.end_time();
  const double left = time > 0 ? seconds * (end - time) / time : INFINITY;
  const std::string line =
      fmt::format("\r\x1b[Kgapcheck: cycle {}, time {:.4g} of {:.4g}, step {:.3g}, energy ratio {:.4f}, {} left",
                  stepper.state().cycle, time, end, stepper.next_step(), stepper.energies().ratio(), duration(left));
  std::fputs(line.c_str(), stderr);
}

}  // namespace gapcheck::app
