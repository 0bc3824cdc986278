#pragma once
#include <cstddef>
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
  double ptol = 0;   ///< only penetrations and separations above it
  double rtol = -1;  ///< only penetrations with a smaller remaining distance; negative: not given
  std::vector<std::int64_t> sid;
  std::string sel;  ///< -sel; empty: all
};

/// True if `sel` is one of the words that -sel accepts.
[[nodiscard]] bool known_selection(const std::string& sel);

/// The records that the options pick (-sid, -sel, -ptol, -rtol); views and exports work on them. Values that a file
/// does not give cannot be judged by -ptol or -rtol and are kept. The contacts' counts are those of the picked records.
[[nodiscard]] Report pick(Report report, const CheckCOptions& options);

/// Only the first `top` records of each interface, as the view shows them (-rsort).
[[nodiscard]] Report top_only(const Report& picked, const CheckCOptions& options);

/// Number of nodes that the report warns about, including those that a file counts without listing them, and
/// run_warnings.
[[nodiscard]] std::uint64_t warning_count(const Report& report);

/// Nodes inside rigid walls, and intersections of elements in contacts with SOFT = 2.
[[nodiscard]] std::uint64_t run_warnings(const Report& report);

/// Initial penetrations that the files count beyond those they list.
[[nodiscard]] std::uint64_t unlisted_penetrations(const ContactSummary& contact);
/// "the solver's summary: 18 nodes, 0.3 to 0.5, …" with what is missing from the list; empty: it gave none.
[[nodiscard]] std::string summary_line(const ContactSummary& contact);

/// False if the file does not say how far the node still is from the surface.
[[nodiscard]] bool knows_remaining(const Report& report, const Penetration& record);

/// The text that check-c prints.
[[nodiscard]] std::string check_c_text(const Report& picked, const CheckCOptions& options);

}  // namespace gapcheck::report
