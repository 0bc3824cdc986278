#pragma once

namespace gapcheck::app {

/// Before the first large array. Memory that is freed stays with the process for the next array, instead of going back
/// to the system and being fetched anew page by page: the stages of an audit allocate and free arrays of a size. For
/// commands whose arrays grow for long, as those of fix, it would leave holes.
void keep_freed_memory();

}  // namespace gapcheck::app
