#pragma once
#include <span>
#include <string>
#include <string_view>

namespace gapcheck {

/// The name that was probably meant: the one that the fewest changed letters make of what was written, case aside, `_`
/// for
/// `-` at half a change. At most a third of the letters, two in a short word, may differ, and less than all of the
/// name. Empty: none is similar. Of equally near names the first.
[[nodiscard]] std::string_view nearest_name(std::string_view written, std::span<const std::string_view> names);

/// "; did you mean NAME?"; empty without a name.
[[nodiscard]] std::string did_you_mean(std::string_view name);

}  // namespace gapcheck
