#include "base/system/signals.hpp"

#include <array>
#include <csignal>
#include <cstddef>

namespace gapcheck::system {
namespace {

std::array<SignalHandler, NSIG> handlers{};

/// Windows takes a handler away when it calls it.
void call_handler(int number) {
  std::signal(number, call_handler);
  handlers[static_cast<std::size_t>(number)](number);
}

}  // namespace

/// Control-C, Control-Break and the end of the session.
std::span<const EndSignal> end_signals() {
  static constexpr std::array signals{EndSignal{SIGINT, "SIGINT", true}, EndSignal{SIGBREAK, "SIGBREAK", true},
                                      EndSignal{SIGTERM, "SIGTERM", true}};
  return signals;
}

void handle_signal(int number, SignalHandler handler) {
  handlers[static_cast<std::size_t>(number)] = handler;
  if (std::signal(number, call_handler) == SIG_IGN) std::signal(number, SIG_IGN);
}

void die_by_signal(int number) {
  std::signal(number, SIG_DFL);
  std::raise(number);
}

void ignore_signals_of_writing() {}

}  // namespace gapcheck::system
