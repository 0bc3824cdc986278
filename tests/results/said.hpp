#pragma once
#include <string>

#include "base/diagnostic.hpp"

namespace gapcheck::results {

/// The diagnostics as lines "error 12: message"; empty where there are none.
inline std::string said(const Diagnostics& diagnostics) {
  std::string text;
  for (const Diagnostic& d : diagnostics.sorted())
    text += (d.severity == Severity::error ? "error " : "warning ") + std::to_string(d.line) + ": " + d.message + "\n";
  return text;
}

}  // namespace gapcheck::results
