#pragma once
#include <cstddef>

namespace gapcheck::system {

inline constexpr int standard_input = 0, standard_output = 1, standard_error = 2;

/// Standard input, output and error are open, take bytes as they are, and show UTF-8 where they lead to a console. For
/// the beginning of main().
void prepare_standard_streams();

[[nodiscard]] bool is_terminal(int descriptor);
/// Whether a terminal knows escape sequences. Windows is asked to obey them.
[[nodiscard]] bool obeys_escapes(int descriptor);
/// Columns of a terminal; 0: it is none, or they are not known.
[[nodiscard]] std::size_t columns_of(int descriptor);

}  // namespace gapcheck::system
