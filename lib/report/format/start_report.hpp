#pragma once
#include <cstddef>
#include <string>

#include "records/start.hpp"

namespace gapcheck::report {

struct StartTextOptions {
  std::size_t top = 10;  ///< pairs of parts, elements, crossings and repeated nodes that are listed
  bool quiet = false;    ///< only the last line
};

/// The text report of a start: a score for each contact, then what happens between which parts.
[[nodiscard]] std::string start_text(const StartReport& report, const StartTextOptions& options);

/// The same as JSON, schema `gapcheck-start/1`, complete.
[[nodiscard]] std::string start_json(const StartReport& report);

}  // namespace gapcheck::report
