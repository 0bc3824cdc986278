#include "common/signals.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>

#include "base/file_writer.hpp"

namespace gapcheck::app {
namespace {

struct NamedSignal {
  int number;
  const char* name;
};
/// What users, terminals and batch systems send when a process must come to its end.
constexpr std::array requests{NamedSignal{SIGINT, "SIGINT"}, NamedSignal{SIGTERM, "SIGTERM"},
                              NamedSignal{SIGHUP, "SIGHUP"}, NamedSignal{SIGXCPU, "SIGXCPU"}};
/// Others that end a process.
constexpr std::array others{SIGQUIT, SIGALRM, SIGUSR1, SIGUSR2, SIGVTALRM};

std::atomic<int> requested = 0;
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler sets it");

void handle(int signal, void (*handler)(int)) {
  struct sigaction action {};
  if (::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN) return;
  action = {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  ::sigaction(signal, &action, nullptr);
}

extern "C" void request_end(int signal) {
  if (requested.exchange(signal) != 0) end_by_signal(signal);
}

}  // namespace

extern "C" void end_by_signal(int signal) {
  remove_uncommitted_files();
  struct sigaction action {};
  action.sa_handler = SIG_DFL;
  ::sigaction(signal, &action, nullptr);
  ::raise(signal);
}

void prepare_process() {
  // A closed standard output would otherwise become the first file that is opened. A folder cannot be written, by
  // the name /dev/stdout neither.
  for (const int fd : {0, 1, 2})
    if (::fcntl(fd, F_GETFD) == -1) static_cast<void>(fd == 2 ? ::open("/dev/null", O_WRONLY) : ::open("/", O_RDONLY));
  struct sigaction ignore {};
  ignore.sa_handler = SIG_IGN;
  for (const int signal : {SIGPIPE, SIGXFSZ}) ::sigaction(signal, &ignore, nullptr);
  for (const NamedSignal& signal : requests) handle(signal.number, end_by_signal);
  for (const int signal : others) handle(signal, end_by_signal);
}

EndRequest::EndRequest() {
  for (const NamedSignal& signal : requests) handle(signal.number, request_end);
}

EndRequest::~EndRequest() {
  for (const NamedSignal& signal : requests) handle(signal.number, end_by_signal);
}

const char* EndRequest::name() {
  for (const NamedSignal& signal : requests)
    if (signal.number == requested) return signal.name;
  return nullptr;
}

}  // namespace gapcheck::app
