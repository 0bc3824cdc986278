#pragma once
#include "records/portability.hpp"
#include "report/write/json_members.hpp"

namespace gapcheck::report {

/// The list "portability" with one object per line, a comma before its key.
void append_portability(const Portability& portability, Buffer& out);

}  // namespace gapcheck::report
