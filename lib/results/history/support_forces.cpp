#include "results/history/support_forces.hpp"

#include <fmt/format.h>

#include "base/number.hpp"
#include "results/text/fortran_number.hpp"
#include "results/text/printed_number.hpp"

namespace gapcheck::results {
namespace {

std::string support_numbers(const Vector& v) {
  return scientific(v.x(), 14, 4) + scientific(v.y(), 14, 4) + scientific(v.z(), 14, 4) + '\n';
}

/// " node=       5 local x,y,z forces =  1.0000E+00  …"; a node has one row or two.
void take_support(ResultText& file, SupportHistory& history) {
  std::string_view rest = behind(file.line(), "node=");
  const auto node = take_integer(rest);
  const bool moments = rest.find("moments") != std::string_view::npos;
  std::string_view numbers = behind(rest, "=");
  if (!node || history.states.empty() || numbers.empty()) return file.unreadable();
  auto& rows = history.states.back().rows;
  if (rows.empty() || rows.back().node != *node) rows.emplace_back().node = *node;
  (moments ? rows.back().moment : rows.back().force) = take_vector(file, numbers);
  (moments ? rows.back().rotation : rows.back().translation) = true;
}

}  // namespace

std::string spcforc_header(const FileHeader& header) {
  return header_text(header) + " single point constraint forces\n\n";
}

std::string spcforc_text(double time, const SupportStates& states) {
  std::string text = fmt::format(" output at time ={}\n", scientific(time, 14, 5));
  for (const SupportState& s : states.supports) {
    if (s.translation) text += fmt::format(" node={:8} local x,y,z forces ={}", s.node, support_numbers(s.force));
    if (s.rotation) text += fmt::format(" node={:8} local x,y,z moments={}", s.node, support_numbers(s.moment));
  }
  return text + fmt::format("             force resultants   ={}", support_numbers(states.resultant));
}

SupportHistory read_spcforc(std::string_view text, const std::string& name, Diagnostics& diagnostics) {
  SupportHistory history;
  ResultText file(text, name, diagnostics);
  for (; !file.done(); file.advance()) {
    const std::string_view line = trimmed(file.line());
    std::string_view rest = behind(line, "=");
    if (line.starts_with("output at time"))
      history.at(file.take(rest));
    else if (line.starts_with("node="))
      take_support(file, history);
    else if (line.starts_with("force resultants"))
      history.add({0, true, false, take_vector(file, rest), Vector::Zero()});
  }
  history.end(file);
  file.finish();
  return history;
}

}  // namespace gapcheck::results
