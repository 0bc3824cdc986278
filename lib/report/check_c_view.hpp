#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "records/report.hpp"

namespace gapcheck::report {

/// The views of check-c, by the names of its options.
struct CheckCOptions {
  bool list = false, bucket = false, pid = false, psum = false, rsort = false, title = false;
  bool type_code = false;     ///< -typ
  bool type_keyword = false;  ///< -type
  bool timestep = false, all = false;
  std::size_t top = 5;
  double ptol = 0;            ///< only penetrations and separations above it
  double rtol = -1;           ///< only penetrations with a smaller remaining distance; negative: not given
  std::vector<std::int64_t> sid;
  std::string sel;            ///< -sel; empty: all
};

/// True if `sel` is one of the words that -sel takes.
[[nodiscard]] bool known_selection(const std::string& sel);

/// The records that the options pick (-sid, -sel, -ptol, -rtol); views and exports work on them.
[[nodiscard]] Report pick(const Report& report, const CheckCOptions& options);

/// The text that check-c prints.
[[nodiscard]] std::string check_c_text(const Report& picked, const CheckCOptions& options);

}  // namespace gapcheck::report
