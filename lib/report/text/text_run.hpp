#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "records/report.hpp"

namespace gapcheck::report {

// What solver files say about the run, as lines of text. Shared by the views of check-c and gapcheck.

/// " LS-DYNA smp d R14, R14.0-515, Double precision, normal termination"; nothing if the files say nothing.
[[nodiscard]] std::string run_line(const SolverRun& run);

/// The time steps of a report, printed by the solver or computed from the deck; nullptr if it has none.
[[nodiscard]] const Timesteps* timesteps(const Report& report);

/// The surface time steps of one contact (position in Report::contacts).
void append_surface_timesteps(const Timesteps& steps, std::uint32_t contact, std::string& out);

/// The limits for the time step of the whole model.
void append_timestep_limits(const Timesteps& steps, std::string& out);

/// Nodes that start inside a rigid wall, deepest first, at most `limit`.
void append_rigidwalls(const SolverRun& run, std::size_t limit, std::string& out);

/// The solver's other messages: with `list` each with its text, otherwise kind and count, and the option that shows
/// more.
void append_messages(const Report& report, bool list, std::string_view option, std::string& out);

}  // namespace gapcheck::report
