#include "base/system/terminal.hpp"

#include <fcntl.h>
#include <io.h>
#include <windows.h>

#include <cstdlib>
#include <initializer_list>

namespace gapcheck::system {
namespace {

UINT code_page_before = 0;

HANDLE console_of(int descriptor) { return reinterpret_cast<HANDLE>(::_get_osfhandle(descriptor)); }

/// NUL is a character device too, but has no mode.
bool has_mode(int descriptor, DWORD& mode) { return ::GetConsoleMode(console_of(descriptor), &mode) != 0; }

}  // namespace

void prepare_standard_streams() {
  for (const int descriptor : {standard_input, standard_output, standard_error})
    static_cast<void>(::_setmode(descriptor, _O_BINARY));
  if (!is_terminal(standard_output) && !is_terminal(standard_error)) return;
  code_page_before = ::GetConsoleOutputCP();
  ::SetConsoleOutputCP(CP_UTF8);
  static_cast<void>(std::atexit([] { ::SetConsoleOutputCP(code_page_before); }));
}

bool is_terminal(int descriptor) {
  DWORD mode = 0;
  return has_mode(descriptor, mode);
}

bool obeys_escapes(int descriptor) {
  DWORD mode = 0;
  return has_mode(descriptor, mode) &&
         ::SetConsoleMode(console_of(descriptor), mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING) != 0;
}

std::size_t columns_of(int descriptor) {
  CONSOLE_SCREEN_BUFFER_INFO info{};
  if (::GetConsoleScreenBufferInfo(console_of(descriptor), &info) == 0) return 0;
  return static_cast<std::size_t>(info.srWindow.Right - info.srWindow.Left + 1);
}

}  // namespace gapcheck::system
