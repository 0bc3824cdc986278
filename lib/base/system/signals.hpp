#pragma once
#include <span>

namespace gapcheck::system {

/// A signal that ends a process. `is_request`: users, terminals and batch systems send it when a process must come to
/// its end.
struct EndSignal {
  int number;
  const char* name;
  bool is_request;
};
[[nodiscard]] std::span<const EndSignal> end_signals();

using SignalHandler = void (*)(int);
/// From now on the handler gets the signal, unless the caller of the program has it ignored.
void handle_signal(int number, SignalHandler handler);
/// Ends the process by the signal, as if nothing had handled it. Async-signal-safe.
void die_by_signal(int number);
/// Writing to a closed pipe, or beyond a limit of file sizes, is an error of the write and no signal.
void ignore_signals_of_writing();

}  // namespace gapcheck::system
