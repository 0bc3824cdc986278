#pragma once
#include <string>
#include <string_view>

#include "program_text.hpp"

namespace gapcheck::manual {

/// A page for man(1), section 1, in the macros of man(7).
[[nodiscard]] std::string man_page(const ProgramText& program, std::string_view version);

}  // namespace gapcheck::manual
