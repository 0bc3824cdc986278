#include "common/signals.hpp"

#include <atomic>

#include "base/file_writer.hpp"
#include "base/system/signals.hpp"
#include "base/system/terminal.hpp"

namespace gapcheck::app {
namespace {

std::atomic<int> requested = 0;
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler sets it");

extern "C" void request_end(int signal) {
  if (requested.exchange(signal) != 0) end_by_signal(signal);
}

void handle_requests(system::SignalHandler handler) {
  for (const system::EndSignal& signal : system::end_signals())
    if (signal.is_request) system::handle_signal(signal.number, handler);
}

}  // namespace

extern "C" void end_by_signal(int signal) {
  remove_uncommitted_files();
  system::die_by_signal(signal);
}

void prepare_process() {
  system::prepare_standard_streams();
  system::ignore_signals_of_writing();
  for (const system::EndSignal& signal : system::end_signals()) system::handle_signal(signal.number, end_by_signal);
}

EndRequest::EndRequest() { handle_requests(request_end); }

EndRequest::~EndRequest() { handle_requests(end_by_signal); }

const char* EndRequest::name() {
  for (const system::EndSignal& signal : system::end_signals())
    if (signal.number == requested) return signal.name;
  return nullptr;
}

}  // namespace gapcheck::app
