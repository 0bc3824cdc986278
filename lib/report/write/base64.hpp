#pragma once
#include <string>
#include <string_view>

namespace gapcheck::report {

/// Appends bytes in base64 (RFC 4648, section 4, with padding).
void append_base64(std::string_view bytes, std::string& out);

}  // namespace gapcheck::report
