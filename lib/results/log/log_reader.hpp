#pragma once
#include <string>
#include <string_view>

#include "results/log/log_collector.hpp"
#include "results/log/message_kinds.hpp"

namespace gapcheck::results {

struct LogFile {
  std::string name;
  bool companion = false;  ///< found or named beside the logs: only contacts and facts are taken
  bool mapped = false;     ///< pages already read may be returned to the system
};

/// Reads one log in one pass into the collector. True if anything in it belongs to a solver's log. Faults of the file
/// go to the collector's diagnostics.
bool read_log_file(std::string_view text, const LogFile& file, const MessageKinds& kinds, LogCollector& collector);

}  // namespace gapcheck::results
