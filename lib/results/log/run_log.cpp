#include "results/log/run_log.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "results/text/fortran_number.hpp"

namespace gapcheck::results {
namespace {

const std::string star_line = " " + std::string(71, '*') + "\n";

/// "a3" as the solver prints it: the number in two columns, the letter before them.
std::string spaced_type(const std::string& type, int width) {
  const std::size_t digits = std::min(type.find_first_of("0123456789"), type.size());
  return fmt::format("{:>{}}", fmt::format("{}{:>2}", type.substr(0, digits), type.substr(digits)), width);
}

/// "       label ......    0.00000E+00"
std::string echo(std::string_view label, double value) {
  return fmt::format("       {:.<45}{}\n", label, normalised(value, 15, 5));
}
std::string echo(std::string_view label, std::int64_t value) {
  return fmt::format("       {:.<45}{:9}\n", label, value);
}

std::string definition(const ContactDefinition& c) {
  std::string text = star_line + fmt::format("\n Contact Interface {:6}\n\n{}\n\n\n", c.id, column_text(c.title, 70));
  text += fmt::format("       {:.<45}{}\n", "contact type", spaced_type(c.type, 6));
  text += fmt::format("       {:.<44}{:10}\n", "contact interface ID ", c.id);
  text += echo("contact order within input deck ", std::int64_t{c.order});
  text += echo("no. of surfa segments", static_cast<std::int64_t>(c.segments_a));
  text += echo("no. of surfb segments", static_cast<std::int64_t>(c.segments_b));
  text += echo("static coefficient of friction ", c.static_friction);
  text += echo("kinetic coefficient of friction", c.kinetic_friction);
  text += echo("exponential decay coefficient ", c.friction_decay);
  text += echo("viscous friction coefficient ", c.viscous_friction);
  text += echo("optional surfa side thickness ", c.thickness_a);
  text += echo("optional surfb side thickness ", c.thickness_b);
  text += echo("scale factor on surfa thickness ", c.thickness_scale_a);
  text += echo("scale factor on surfb thickness (def.=1.0)", c.thickness_scale_b);
  text += echo("birth time ", c.birth);
  text += echo("death time ", c.death);
  text += echo("penetration treatment for auto contact ", c.ignore);
  return text + echo("constraint formulation ", c.soft) + "\n";
}

}  // namespace

std::string log_banner(const FileHeader& header) {
  const auto line = [](std::string_view text) { return fmt::format("     |  {}|\n", column_text(text, 49)); };
  const std::string edge(51, '_');
  return fmt::format("\n      {} \n", edge) + line("") + line("gapcheck, explicit verification solver") +
         line("Version : " + header.program) + line("Precision  : Double precision") +
         fmt::format("     |{}|\n\n", edge) + header_text(header);
}

std::string contact_definitions(std::span<const ContactDefinition> contacts) {
  std::string text;
  write_contact_definitions(contacts, [&](std::string_view piece) { text += piece; });
  return text;
}

void write_contact_definitions(std::span<const ContactDefinition> contacts, const TextSink& sink) {
  if (contacts.empty()) return;
  sink("\n c o n t a c t   i n t e r f a c e s\n");
  for (const ContactDefinition& contact : contacts) sink(definition(contact));
  sink(star_line + "\n\n  Contact summary \n\n  Order #  Contact ID   Type                     Title\n\n");
  for (const ContactDefinition& c : contacts)
    sink(fmt::format("{:9}{:12}{} {}\n", c.order, c.id, spaced_type(c.type, 7), column_text(c.title, 70)));
  sink("\n" + star_line);
}

std::string surface_timesteps(const Timesteps& timesteps, std::span<const ContactSummary> contacts) {
  std::string text;
  write_surface_timesteps(timesteps, contacts, [&](std::string_view piece) { text += piece; });
  return text;
}

void write_surface_timesteps(const Timesteps& timesteps, std::span<const ContactSummary> contacts,
                             const TextSink& sink) {
  bool any = false;
  double least = no_timestep_limit;
  for (const SurfaceTimestep& step : timesteps.surface_timesteps) {
    if (step.contact >= contacts.size()) continue;
    any = true;
    least = std::min(least, step.timestep);
    const char* side = step.side == 'A' ? "surfa" : "surfb";
    std::string text = "\n";
    const auto row = [&](const std::string& label, const std::string& value) {
      text += fmt::format("     {:<29}={}\n", label, value);
    };
    row(fmt::format("{} surface of interface", side), fmt::format(" {}", contacts[step.contact].id));
    row("type", spaced_type(step.type, 10));
    row("surface timestep", scientific(step.timestep, 10, 3));
    row(fmt::format("controlling {} node ID", side), fmt::format(" {}", step.node));
    row(fmt::format("part ID of {} node", side), fmt::format(" {}", step.part));
    row("current minimum time step", scientific(least, 10, 3));
    sink(text);
  }
  if (any)
    sink(
        fmt::format("\n The time step size should not exceed {}\n to avoid contact instabilities.  If the "
                    "step size is\n bigger then scale the penalty of the offending surface.\n",
                    scientific(least, 13, 3)));
}

std::string smallest_timesteps(std::span<const ElementStep> steps) {
  if (steps.empty()) return "";
  std::string text =
      "\n\n 100 smallest timesteps\n ------------------------------------------------\n"
      " element       number                part    timestep\n";
  for (const ElementStep& step : steps.first(std::min<std::size_t>(steps.size(), 100)))
    text += fmt::format(" {:<6}{:>14}{:>20}{}\n", step.kind, step.element, step.part, scientific(step.timestep, 12, 4));
  return text + "\n";
}

std::string failed_element(const std::string& kind, std::int64_t element, double time) {
  return fmt::format(" {} element {:9} failed at time {}\n", kind, element, scientific(time, 11, 4));
}

std::string cycle_line(std::uint64_t cycle, double time, double time_step, const std::string& what) {
  return fmt::format("{:8} t{} dt{} {}\n", cycle, scientific(time, 11, 4), scientific(time_step, 9, 2), what);
}

std::string log_end(bool normal, const std::string& reason, double time, std::uint64_t cycle) {
  return fmt::format("\n *** {} ***\n\n Problem time       = {}\n Problem cycle      = {:9}\n\n {}\n", reason,
                     scientific(time, 13, 4), cycle,
                     normal ? "N o r m a l    t e r m i n a t i o n" : "E r r o r   t e r m i n a t i o n");
}

std::string contact_warning(std::int64_t contact, double time, const std::string& text) {
  return fmt::format(" \n *** Warning\n     contact interface # = {}\n     time = {:.4E}\n     {}{} \n", contact, time,
                     text, text.ends_with('\n') ? "" : "\n");
}

std::string soft_switch_block(std::int64_t contact) {
  return fmt::format(
      " \n *** Warning 20535 (STR+535)\n     contact interface # {} was switched from SOFT=2 to SOFT=1\n"
      "     and the value of DEPTH was switched to the default value.\n"
      "     The segment based contact option is only valid for\n"
      "     contact types 3, a3, 4, 13, 14, 15, 10, and a10\n",
      contact);
}

std::string error_block(const std::string& text) { return " \n *** Error\n     " + text + "\n \n"; }

}  // namespace gapcheck::results
