#pragma once

namespace gapcheck::app {

/// For the beginning of main(). Writing to a closed pipe or beyond a limit of file sizes then is an error of the write
/// and no signal; signals that end the process first delete what is half written; descriptors 0 to 2 are never those of
/// other files.
void prepare_process();

/// Deletes what is half written and ends the process by this signal. A signal handler.
extern "C" void end_by_signal(int signal);

/// While it lives, the first signal that asks the process to end is only remembered; a second one ends it. Signals that
/// the caller of the program ignores stay ignored.
class EndRequest {
 public:
  EndRequest();
  ~EndRequest();
  EndRequest(const EndRequest&) = delete;
  EndRequest& operator=(const EndRequest&) = delete;
  /// "SIGTERM"; null: none has come.
  [[nodiscard]] static const char* name();
};

}  // namespace gapcheck::app
