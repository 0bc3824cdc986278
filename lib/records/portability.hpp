#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace gapcheck {

/// What of a deck's contacts another program does not read.
enum class PortabilityKind : std::uint8_t { keyword, option, field };

/// "keyword", "option", "field".
[[nodiscard]] constexpr std::string_view name(PortabilityKind kind) {
  switch (kind) {
    case PortabilityKind::keyword:
      return "keyword";
    case PortabilityKind::option:
      return "option";
    case PortabilityKind::field:
      return "field";
  }
  return "";
}

/// One keyword, option or field, once per program, with the number of contacts that have it.
struct PortabilityNote {
  std::string program;  ///< "Altair Radioss"
  PortabilityKind kind = PortabilityKind::keyword;
  bool other_meaning = false;  ///< the program reads it, but as something else
  std::string name;            ///< "CONTACT_ERODING_SINGLE_SURFACE", "MPP", "SOFSCL"
  std::uint64_t count = 1;     ///< contacts
  std::string file;            ///< the first place
  std::uint32_t line = 0;
  std::string source;  ///< the document that says so, for the contact at the first place
};

/// What was compared, and what came out; keywords first, then options, then fields, each by first place.
struct Portability {
  std::vector<std::string> programs;
  std::vector<PortabilityNote> notes;
};

}  // namespace gapcheck
