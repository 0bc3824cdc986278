#pragma once
#include <cstddef>
#include <string>

#include "records/fix.hpp"

namespace gapcheck::report {

struct FixTextOptions {
  std::size_t top = 10;  ///< moved nodes, unfixed nodes and pairs of parts that are listed
  bool quiet = false;    ///< only the last line
};

/// The text report of a correction: contacts before and after, moves, what remains and what else could be done.
[[nodiscard]] std::string fix_text(const FixReport& report, const FixTextOptions& options);

/// The last line of the text: "18 nodes penetrating before, 0 after; …", without its end.
[[nodiscard]] std::string said_of(const FixReport& report);

/// The same as JSON, schema `gapcheck-fix/1`, complete.
[[nodiscard]] std::string fix_json(const FixReport& report);

}  // namespace gapcheck::report
