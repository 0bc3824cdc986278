#pragma once
#include <string>
#include <string_view>

namespace gapcheck::report {

/// Text for XML and HTML, between tags or in quotes: the five special characters escaped, control characters (also
/// U+0080 to U+009F) and bytes that are not UTF-8 replaced by '?'.
[[nodiscard]] std::string xml_text(std::string_view text);

/// The same for the value of an attribute of XML: readers make newlines and tabs blanks there, unless they are escaped.
[[nodiscard]] std::string xml_attribute(std::string_view text);

/// The same without the escapes: text that any reader accepts as UTF-8, with newlines and tabs, and no other control
/// characters.
[[nodiscard]] std::string plain_text(std::string_view text);

}  // namespace gapcheck::report
