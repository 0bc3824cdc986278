#include <algorithm>
#include <cstddef>
#include <cwchar>

namespace {

struct Character {
  unsigned code = 0;
  std::size_t length = 0;
};

/// The character of UTF-8 that begins here; what is none is one byte of Latin-1.
Character character_at(const unsigned char* at, std::size_t length) {
  const Character byte{*at, 1};
  const std::size_t count = *at < 0xc2 ? 1 : *at < 0xe0 ? 2 : *at < 0xf0 ? 3 : *at < 0xf5 ? 4 : 1;
  if (count == 1 || count > length) return byte;
  unsigned code = *at & (0xffU >> (count + 1));
  for (std::size_t i = 1; i < count; ++i) {
    if ((at[i] & 0xc0) != 0x80) return byte;
    code = code << 6 | (at[i] & 0x3fU);
  }
  const bool is_half = code >= 0xd800 && code < 0xe000;
  return is_half || code > 0x10ffff || (count == 4 && code < 0x10000) ? byte : Character{code, count};
}

}  // namespace

/// std::filesystem makes its wide names from those of the program by this function of the C library, which knows no
/// UTF-8 in msvcrt.dll; this one takes its place in the program. Bytes that are no UTF-8 are taken as Latin-1, as old
/// decks have them, and for names of hostile decks nothing may be thrown.
extern "C" std::size_t mbrtowc(wchar_t* to, const char* from, std::size_t length, std::mbstate_t* state) {
  if (from == nullptr) return 0;
  if (length == 0) return static_cast<std::size_t>(-2);
  static std::mbstate_t own_state{};
  std::mbstate_t& second_half = state != nullptr ? *state : own_state;
  Character found{static_cast<unsigned>(second_half), 1};
  if (second_half != 0) {  // of a character of four bytes, with the last of them
    second_half = 0;
  } else {
    found = character_at(reinterpret_cast<const unsigned char*>(from), length);
    if (found.length == 4) {
      second_half = static_cast<std::mbstate_t>(0xdc00 | ((found.code - 0x10000) & 0x3ff));
      found = {0xd800 | (found.code - 0x10000) >> 10, 3};
    }
  }
  if (to != nullptr) *to = static_cast<wchar_t>(found.code);
  return found.code == 0 ? 0 : found.length;
}
