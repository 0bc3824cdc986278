#pragma once
#include <string>
#include <vector>

#include "records/report.hpp"
#include "report/write/json_members.hpp"

namespace gapcheck::report {

/// What solver files say about the run, if there is one.
void append_run(const Report& report, Buffer& out);

/// Time steps that were computed from a deck: of one contact (position in Report::contacts), each side with its
/// controlling node, and of the whole model. Nothing if none were computed.
void append_predicted_timesteps(const Report& report, std::uint32_t contact, Members& object, Buffer& out);
void append_predicted_limits(const Report& report, Buffer& out);

/// One finding of GC201, GC202 or GC204. `files`: the report's file names, quoted.
void append_tie_failure(const Report& report, const TieFailure& failure, const std::vector<std::string>& files,
                        std::optional<BaselineState> state, Buffer& out);

}  // namespace gapcheck::report
