#include "results/history/element_stress.hpp"

#include <fmt/format.h>

#include "results/text/fortran_number.hpp"

namespace gapcheck::results {
namespace {

std::string stress_heading(std::uint64_t cycle, double time) {
  return fmt::format(
      "\n\n\n e l e m e n t   s t r e s s   c a l c u l a t i o n s   f o r   t i m e  s t e p{:9}   ( "
      "at time{} )\n\n",
      cycle, scientific(time, 12, 5));
}

std::string stress_columns(const StressRow& point) {
  std::string text;
  for (const double s : point.stress) text += scientific(s, 12, 4);
  return text;
}

const char* stress_state(const StressRow& point) { return point.plastic ? "plastic" : "elastic"; }

std::string solid_rows(const ElementStress& e) {
  std::string text = fmt::format("{:8}-{:7}\n", e.id, e.part);
  for (const StressRow& point : e.points)
    text += fmt::format("       1 {:<7} ", stress_state(point)) + stress_columns(point) +
            scientific(point.effective, 14, 4) + scientific(point.plastic_strain, 14, 4) + '\n';
  return text;
}

std::string shell_rows(const ElementStress& e) {
  std::string text = fmt::format("{:8}-{:7}\n", e.id, e.part);
  for (std::size_t i = 0; i < e.points.size(); ++i)
    text += fmt::format("{:4}-{:3} {:<7} ", i % e.layers + 1, i / e.layers + 1, stress_state(e.points[i])) +
            stress_columns(e.points[i]) + scientific(e.points[i].plastic_strain, 14, 4) + '\n';
  return text;
}

std::string beam_rows(const ElementStress& e) {
  std::string text = fmt::format("\n\n\n\n beam/truss # ={:8}      material #  ={:5}\n", e.id, e.part);
  text += "\n\n resultants      axial    shear-s    shear-t    moment-s   moment-t   torsion\n           ";
  for (const double value : e.resultants) text += scientific(value, 11, 3);
  text += '\n';
  if (e.points.empty()) return text;
  text +=
      "\n\n integration point stresses\n                       sigma 11       sigma 12       sigma 31   plastic  "
      "eps\n";
  for (std::size_t i = 0; i < e.points.size(); ++i) {
    const StressRow& p = e.points[i];
    text += fmt::format("{:5}           ", i + 1) + scientific(p.stress[0], 15, 6) + scientific(p.stress[3], 15, 6) +
            scientific(p.stress[5], 15, 6) + scientific(p.plastic_strain, 15, 6) + '\n';
  }
  return text;
}

}  // namespace

std::string_view name(StressKind kind) {
  return kind == StressKind::solid ? "solid" : kind == StressKind::beam ? "beam" : "shell";
}

std::string elout_header(const FileHeader& header, std::vector<LegendEntry> elements) {
  return header_text(header) + legend_text(std::move(elements), 70) + '\n';
}

std::string elout_text(std::uint64_t cycle, double time, bool local, std::span<const ElementStress> elements) {
  std::string solids, beams, shells;
  for (const ElementStress& e : elements)
    (e.kind == StressKind::solid  ? solids
     : e.kind == StressKind::beam ? beams
                                  : shells) += e.kind == StressKind::solid  ? solid_rows(e)
                                               : e.kind == StressKind::beam ? beam_rows(e)
                                                                            : shell_rows(e);
  std::string text;
  if (!solids.empty())
    text += stress_heading(cycle, time) +
            " element  materl\n     ipt  stress       sig-xx      sig-yy      sig-zz      sig-xy      sig-yz      "
            "sig-zx                       yield\n           state" +
            std::string(82, ' ') + "effsg      function\n" + solids;
  if (!beams.empty())
    text += fmt::format(
                "\n\n\n\n r e s u l t a n t s   a n d   s t r e s s e s   f o r   t i m e  s t e p{:9}   ( at "
                "time{} )\n",
                cycle, scientific(time, 12, 5)) +
            beams;
  if (!shells.empty())
    text += stress_heading(cycle, time) + fmt::format(" element  materl{:<8}\n", local ? "(local)" : "(global)") +
            " ipt-shl  stress       sig-xx      sig-yy      sig-zz      sig-xy      sig-yz      sig-zx       plastic\n"
            "           state" +
            std::string(81, ' ') + "strain \n" + shells;
  return text;
}

}  // namespace gapcheck::results
