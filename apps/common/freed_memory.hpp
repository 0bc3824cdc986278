#pragma once

namespace gapcheck::app {

/// For the beginning of main(). Memory that is freed stays with the process for the next array, instead of going back
/// to the system and being fetched anew page by page: the stages of an audit allocate and free arrays of a size. The
/// most memory that a command needs does not change by it.
void keep_freed_memory();

}  // namespace gapcheck::app
