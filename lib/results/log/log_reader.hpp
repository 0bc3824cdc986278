#pragma once
#include <string>
#include <string_view>

#include "base/file_bytes.hpp"
#include "results/log/log_collector.hpp"
#include "results/log/message_kinds.hpp"

namespace gapcheck::results {

struct LogFile {
  std::string name;
  bool companion = false;  ///< found or named beside the logs: only contacts and facts are taken
};

/// Reads one log in one pass into the collector. True if anything in it belongs to a solver's log. Faults of the file
/// go to the collector's diagnostics.
bool read_log_file(std::string_view text, const LogFile& file, const MessageKinds& kinds, LogCollector& collector);

/// The same for a file on disk, of which a few megabytes at a time are in memory.
bool read_log_file(FileBytes& bytes, const LogFile& file, const MessageKinds& kinds, LogCollector& collector);

}  // namespace gapcheck::results
