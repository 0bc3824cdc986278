#pragma once

namespace gapcheck::app {

/// True if a descriptor leads to a terminal that knows escape sequences: not with TERM=dumb.
[[nodiscard]] bool obeys_escapes(int descriptor);

}  // namespace gapcheck::app
