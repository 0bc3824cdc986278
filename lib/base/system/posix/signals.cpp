#include "base/system/signals.hpp"

#include <array>
#include <csignal>

namespace gapcheck::system {

std::span<const EndSignal> end_signals() {
  static constexpr std::array signals{EndSignal{SIGINT, "SIGINT", true},       EndSignal{SIGTERM, "SIGTERM", true},
                                      EndSignal{SIGHUP, "SIGHUP", true},       EndSignal{SIGXCPU, "SIGXCPU", true},
                                      EndSignal{SIGQUIT, "SIGQUIT", false},    EndSignal{SIGALRM, "SIGALRM", false},
                                      EndSignal{SIGUSR1, "SIGUSR1", false},    EndSignal{SIGUSR2, "SIGUSR2", false},
                                      EndSignal{SIGVTALRM, "SIGVTALRM", false}};
  return signals;
}

void handle_signal(int number, SignalHandler handler) {
  struct sigaction action {};
  if (::sigaction(number, nullptr, &action) == 0 && action.sa_handler == SIG_IGN) return;
  action = {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  ::sigaction(number, &action, nullptr);
}

void die_by_signal(int number) {
  struct sigaction action {};
  action.sa_handler = SIG_DFL;
  ::sigaction(number, &action, nullptr);
  ::raise(number);
}

void ignore_signals_of_writing() {
  struct sigaction ignore {};
  ignore.sa_handler = SIG_IGN;
  for (const int signal : {SIGPIPE, SIGXFSZ}) ::sigaction(signal, &ignore, nullptr);
}

}  // namespace gapcheck::system
