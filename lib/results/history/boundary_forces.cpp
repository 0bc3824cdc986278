#include "results/history/boundary_forces.hpp"

#include <fmt/format.h>

#include <array>

#include "base/number.hpp"
#include "results/text/fortran_number.hpp"
#include "results/text/printed_number.hpp"

namespace gapcheck::results {
namespace {

struct BoundaryHeading {
  BoundaryKind kind;
  std::string_view name, words;
};

constexpr std::array<BoundaryHeading, 3> boundary_headings{{
    {BoundaryKind::discrete, "discrete", "discrete nodal point forces"},
    {BoundaryKind::pressure, "pressure", "pressure boundary condition forces"},
    {BoundaryKind::velocity, "velocity", "velocity boundary condition forces/rigid body moments"},
}};

std::string boundary_numbers(std::string_view word, const Vector& v, double energy) {
  return fmt::format("x{}={}   y{}={}  z{}={}", word, scientific(v.x(), 13, 4), word, scientific(v.y(), 13, 4), word,
                     scientific(v.z(), 13, 4)) +
         fmt::format("   {}={}\n", word == "total" ? "etotal" : "energy", scientific(energy, 13, 4));
}

/// Rigid bodies are called "mt" under loads and "mat" under motions.
std::string boundary_row(const BoundaryState& s) {
  const char* what = !s.body ? " nd" : s.kind == BoundaryKind::velocity ? "mat" : " mt";
  std::string text = fmt::format("{}#{:8}  ", what, s.id) + boundary_numbers("force", s.force, s.energy);
  if (s.body && s.kind == BoundaryKind::velocity)
    text += fmt::format("             xmoment={}  ymoment={} zmoment={}\n", scientific(s.moment.x(), 13, 4),
                        scientific(s.moment.y(), 13, 4), scientific(s.moment.z(), 13, 4));
  return text;
}

/// The number behind "xforce=".
double number_behind(ResultText& file, std::string_view word) {
  std::string_view rest = behind(file.line(), word);
  return file.take(rest);
}

Vector vector_behind(ResultText& file, std::string_view word) {
  return {number_behind(file, fmt::format("x{}=", word)), number_behind(file, fmt::format("y{}=", word)),
          number_behind(file, fmt::format("z{}=", word))};
}

void take_boundary_row(ResultText& file, BoundaryKind kind, bool body, BoundaryHistory& history) {
  std::string_view rest = behind(file.line(), "#");
  const auto id = take_integer(rest);
  if (!id) return file.unreadable();
  history.add({kind, body, *id, vector_behind(file, "force"), number_behind(file, "energy="), Vector::Zero()});
}

}  // namespace

std::string_view name(BoundaryKind kind) { return boundary_headings[static_cast<std::size_t>(kind)].name; }

std::string bndout_header(const FileHeader& header) { return header_text(header); }

std::string bndout_text(double time, const std::vector<BoundaryState>& states) {
  std::string text;
  for (const BoundaryHeading& heading : boundary_headings) {
    std::string rows;
    Vector sum = Vector::Zero();
    double energy = 0;
    for (const bool body : {false, true})
      for (const BoundaryState& s : states) {
        if (s.kind != heading.kind || s.body != body) continue;
        rows += boundary_row(s);
        sum += s.force;
        energy += s.energy;
      }
    if (rows.empty()) continue;
    text += fmt::format("\n\n\n\n\n n o d a l   f o r c e/e n e r g y    o u t p u t   t={}\n", scientific(time, 9, 3));
    text += fmt::format("\n\n\n\n\n {} \n\n{}", heading.words, rows);
    text += "              " + boundary_numbers("total", sum, energy);
  }
  return text;
}

BoundaryHistory read_bndout(std::string_view text, const std::string& name, Diagnostics& diagnostics) {
  BoundaryHistory history;
  ResultText file(text, name, diagnostics);
  BoundaryKind kind = BoundaryKind::discrete;
  for (; !file.done(); file.advance()) {
    if (file.take_legend(history.titles)) continue;
    const std::string_view line = trimmed(file.line());
    for (const BoundaryHeading& heading : boundary_headings)
      if (line == heading.words) kind = heading.kind;
    std::string_view time = behind(line, "t=");
    if (line.starts_with("n o d a l"))
      history.at(file.take(time));
    else if (line.starts_with("nd#"))
      take_boundary_row(file, kind, false, history);
    else if (line.starts_with("mt#") || line.starts_with("mat#"))
      take_boundary_row(file, kind, true, history);
    else if (line.starts_with("xmoment=") && !history.states.empty() && !history.states.back().rows.empty())
      history.states.back().rows.back().moment = vector_behind(file, "moment");
  }
  history.end(file);
  file.finish();
  return history;
}

}  // namespace gapcheck::results
