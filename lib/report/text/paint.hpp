#pragma once
#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "base/diagnostic.hpp"

namespace gapcheck::report {

/// ANSI colours, or nothing.
struct Paint {
  bool on;
  [[nodiscard]] std::string operator()(std::string_view code, std::string_view text) const {
    return on ? fmt::format("\x1b[{}m{}\x1b[0m", code, text) : std::string(text);
  }
  [[nodiscard]] std::string bold(std::string_view text) const { return (*this)("1", text); }
  [[nodiscard]] std::string severity(Severity severity, std::string_view text) const {
    return (*this)(severity == Severity::error ? "31" : severity == Severity::warning ? "33" : "36", text);
  }
};

/// "1 node", "2 nodes".
inline std::string count(std::uint64_t number, std::string_view noun) {
  return fmt::format("{} {}{}", number, noun, number == 1 ? "" : "s");
}

}  // namespace gapcheck::report
