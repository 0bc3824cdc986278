#include "results/curves/matsum.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/number.hpp"
#include "results/text/fortran_number.hpp"
#include "results/text/printed_number.hpp"
#include "results/text/result_text.hpp"

namespace gapcheck::results {
namespace {

std::string vector_row(std::string_view what, const Vector& v) {
  return fmt::format(" x-{0}={1}     y-{0}={2}     z-{0}={3}\n", what, scientific(v.x(), 13, 4),
                     scientific(v.y(), 13, 4), scientific(v.z(), 13, 4));
}

/// The word that ends at `end`; only its last letters if it is longer than any label.
std::string_view label_before(std::string_view line, std::size_t end) {
  constexpr std::size_t longest = 16;
  const std::string_view near = line.substr(end > longest ? end - longest : 0, std::min(end, longest));
  return near.substr(near.find_last_of(' ') + 1);
}

double* part_value(std::string_view label, PartState& part) {
  if (label == "inten") return &part.internal;
  if (label == "kinen") return &part.kinetic;
  if (label == "hgeng") return &part.hourglass;
  if (label == "eroded_ie") return &part.eroded_internal;
  if (label == "eroded_he") return &part.eroded_hourglass;
  if (label.size() != 5 || label[0] < 'x' || label[0] > 'z') return nullptr;
  if (label.substr(1) == "-mom") return &part.momentum[label[0] - 'x'];
  return label.substr(1) == "-rbv" ? &part.velocity[label[0] - 'x'] : nullptr;
}

/// Reads states; counts the values of each to see where the last one was cut off.
class MatsumReader {
 public:
  MatsumReader(ResultText& file, PartHistory& history) : file_(file), history_(history) {}

  void line(std::string_view line) {
    const std::size_t first = line.find('=');
    for (std::size_t at = first; at != std::string_view::npos; at = line.find('=', at + 1)) {
      std::string_view rest = line.substr(at + 1);
      const std::string_view label = label_before(line, at);
      if (at == first && trimmed(line.substr(0, at)) == "time")
        begin(file_.take(rest));
      else if (label == "mat.#")
        part(rest);
      else if (in_part_)
        value(label, rest);
    }
  }

  void finish() {
    if (values_ >= values_before_) return;
    history_.states.pop_back();
    file_.incomplete();
  }

 private:
  void begin(double time) {
    in_part_ = false;
    in_state_ = time == time;
    if (!in_state_) return;
    history_.states.push_back({time, {}});
    values_before_ = values_;
    values_ = 0;
  }

  void part(std::string_view rest) {
    const auto id = take_integer(rest);
    if (!id) file_.unreadable();
    in_part_ = id && in_state_;
    if (in_part_) history_.states.back().parts.emplace_back().part = *id;
  }

  void value(std::string_view label, std::string_view rest) {
    double* place = part_value(label, history_.states.back().parts.back());
    if (place == nullptr) return;
    *place = file_.take(rest);
    ++values_;
  }

  ResultText& file_;
  PartHistory& history_;
  bool in_state_ = false, in_part_ = false;
  std::size_t values_ = 0, values_before_ = 0;
};

}  // namespace

std::string matsum_header(const FileHeader& header, std::vector<LegendEntry> parts) {
  return header_text(header) + legend_text(std::move(parts), 72);
}

std::string matsum_text(double time, std::span<const PartState> parts) {
  const std::string zero = scientific(0, 13, 4);
  std::string text = fmt::format("\n\n\n time ={}\n", scientific(time, 13, 4));
  for (const PartState& part : parts) {
    text += fmt::format(" mat.#={:5}             inten={}     kinen={}     eroded_ie={}     eroded_ke={}\n", part.part,
                        scientific(part.internal, 13, 4), scientific(part.kinetic, 13, 4),
                        scientific(part.eroded_internal, 13, 4), zero);
    text += vector_row("mom", part.momentum);
    text += vector_row("rbv", part.velocity);
    text += fmt::format("                         hgeng={}     +mass={}     eroded_he={}\n\n\n",
                        scientific(part.hourglass, 13, 4), zero, scientific(part.eroded_hourglass, 13, 4));
  }
  return text;
}

PartHistory read_matsum(std::string_view text, const std::string& name, Diagnostics& diagnostics) {
  PartHistory history;
  ResultText file(text, name, diagnostics);
  MatsumReader reader(file, history);
  for (; !file.done(); file.advance())
    if (!file.take_legend(history.titles)) reader.line(file.line());
  reader.finish();
  file.finish();
  return history;
}

}  // namespace gapcheck::results
