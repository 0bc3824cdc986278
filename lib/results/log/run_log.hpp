#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "records/report.hpp"
#include "results/text/file_header.hpp"

namespace gapcheck::results {

// The parts of the messag and d3hsp of our own runs besides message_blocks(); our readers read them back.

/// Takes a piece of a text.
using TextSink = std::function<void(std::string_view)>;

/// What d3hsp echoes of one contact definition.
struct ContactDefinition {
  std::int64_t id = 0;
  std::uint32_t order = 0;
  std::string type;  ///< "13", "a3"
  std::string title;
  std::uint64_t segments_a = 0, segments_b = 0;
  double static_friction = 0, kinetic_friction = 0, friction_decay = 0, viscous_friction = 0;
  double thickness_a = 0, thickness_b = 0, thickness_scale_a = 1, thickness_scale_b = 1;
  double birth = 0, death = 1e20;
  std::int64_t ignore = 0, soft = 0;
};

/// Stable step of one element.
struct ElementStep {
  std::string kind;  ///< "shell"
  std::int64_t element = 0, part = 0;
  double timestep = 0;
};

/// Box with the program's name, then title and stamp.
[[nodiscard]] std::string log_banner(const FileHeader& header);
/// Contact interfaces one by one and the summary table; empty without contacts.
[[nodiscard]] std::string contact_definitions(std::span<const ContactDefinition> contacts);
/// The same in pieces, one after the other: of 100,000 contacts they are 140 MB.
void write_contact_definitions(std::span<const ContactDefinition> contacts, const TextSink& sink);
/// Surface time steps, and the smallest of them as the step that should not be exceeded. `contacts`: ids by position.
[[nodiscard]] std::string surface_timesteps(const Timesteps& timesteps, std::span<const ContactSummary> contacts);
void write_surface_timesteps(const Timesteps& timesteps, std::span<const ContactSummary> contacts,
                             const TextSink& sink);
/// Table of at most 100 rows.
[[nodiscard]] std::string smallest_timesteps(std::span<const ElementStep> steps);
/// "       1 t 0.0000E+00 dt 2.12E-04 write d3plot file"
[[nodiscard]] std::string cycle_line(std::uint64_t cycle, double time, double time_step, const std::string& what);
/// " shell element        12 failed at time  1.2345E-03". `kind`: "shell" or "solid"
[[nodiscard]] std::string failed_element(const std::string& kind, std::int64_t element, double time);
/// Why the run ended, its time and cycle (from 1), and the last line: normal or error termination.
[[nodiscard]] std::string log_end(bool normal, const std::string& reason, double time, std::uint64_t cycle);
/// A warning without a number about a contact; `text`: lines, the first without leading blanks.
[[nodiscard]] std::string contact_warning(std::int64_t contact, double time, const std::string& text);
/// The warning that a contact's SOFT = 2 is treated as 1.
[[nodiscard]] std::string soft_switch_block(std::int64_t contact);
/// An error without a number.
[[nodiscard]] std::string error_block(const std::string& text);

}  // namespace gapcheck::results
