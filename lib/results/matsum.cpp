#include "results/matsum.hpp"

#include <fmt/format.h>

#include "results/fortran_number.hpp"

namespace gapcheck::results {
namespace {

std::string vector_row(std::string_view what, const Vector& v) {
  return fmt::format(" x-{0}={1}     y-{0}={2}     z-{0}={3}\n", what, scientific(v.x(), 13, 4),
                     scientific(v.y(), 13, 4), scientific(v.z(), 13, 4));
}

}  // namespace

std::string matsum_header(const FileHeader& header, std::vector<LegendEntry> parts) {
  return header_text(header) + legend_text(std::move(parts), 72);
}

std::string matsum_text(double time, std::span<const PartState> parts) {
  const std::string zero = scientific(0, 13, 4);
  std::string text = fmt::format("\n\n\n time ={}\n", scientific(time, 13, 4));
  for (const PartState& part : parts) {
    text += fmt::format(" mat.#={:5}             inten={}     kinen={}     eroded_ie={}     eroded_ke={}\n", part.part,
                        scientific(part.internal, 13, 4), scientific(part.kinetic, 13, 4), zero, zero);
    text += vector_row("mom", part.momentum);
    text += vector_row("rbv", part.velocity);
    text += fmt::format("                         hgeng={}     +mass={}     eroded_he={}\n\n\n",
                        scientific(part.hourglass, 13, 4), zero, zero);
  }
  return text;
}

}  // namespace gapcheck::results
