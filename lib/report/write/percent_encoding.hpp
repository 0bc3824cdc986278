#pragma once
#include <string>
#include <string_view>

namespace gapcheck::report {

/// A path as a link: every byte that has a meaning there is escaped, so that no path is taken for an address.
[[nodiscard]] std::string percent_encoded(std::string_view path);

/// A path as the reference of a URI, without `.` and `..`; an absolute one gets the scheme `file:`.
[[nodiscard]] std::string file_uri(std::string_view path);

}  // namespace gapcheck::report
