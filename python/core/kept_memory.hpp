#pragma once

namespace gapcheck::python {

/// While one lives, large blocks that the library frees are kept for the next ones that it asks for. The C library
/// would give them back to the system at once, whose fresh pages cost a tenth of an audit's time. The program has this
/// from the C library's settings, which are the whole process's and not a module's to change. The last one frees what
/// is kept.
class KeptMemory {
 public:
  KeptMemory();
  ~KeptMemory();
  KeptMemory(const KeptMemory&) = delete;
  KeptMemory& operator=(const KeptMemory&) = delete;
};

}  // namespace gapcheck::python
