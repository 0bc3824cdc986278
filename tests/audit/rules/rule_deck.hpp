#pragma once
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "audit/run.hpp"

namespace gapcheck::audit_test {

/// A small deck in free format, built up piece by piece. Materials: 1 is elastic steel (mm, t, s), 2 the same but
/// rigid.
class RuleDeck {
 public:
  RuleDeck& node(std::int64_t id, const Vector& x) {
    nodes_ += fmt::format("{},{},{},{}\n", id, x[0], x[1], x[2]);
    return *this;
  }
  /// Three or four nodes.
  RuleDeck& shell(std::int64_t id, std::int64_t part, const std::vector<std::int64_t>& n) {
    shells_ += fmt::format("{},{},{},{},{},{}\n", id, part, n[0], n[1], n[2], n.size() > 3 ? n[3] : n[2]);
    return *this;
  }
  RuleDeck& solid(std::int64_t id, std::int64_t part, const std::array<std::int64_t, 8>& n) {
    solids_ += fmt::format("{},{},{}\n", id, part, fmt::join(n, ","));
    return *this;
  }
  RuleDeck& beam(std::int64_t id, std::int64_t part, std::int64_t a, std::int64_t b) {
    beams_ += fmt::format("{},{},{},{}\n", id, part, a, b);
    return *this;
  }
  RuleDeck& shell_part(std::int64_t id, double thickness, std::int64_t material = 1) {
    return part(id, material, fmt::format("*SECTION_SHELL\n{},2,0.833,5\n{}\n", id, thickness));
  }
  RuleDeck& solid_part(std::int64_t id, std::int64_t material = 1) {
    return part(id, material, fmt::format("*SECTION_SOLID\n{},1\n", id));
  }
  /// Tubes of this outer diameter.
  RuleDeck& beam_part(std::int64_t id, double diameter, std::int64_t material = 1) {
    return part(id, material, fmt::format("*SECTION_BEAM\n{},1,1.0,2,1\n{},{},0,0\n", id, diameter, diameter));
  }
  /// nx x ny quads of size dx x dy from `corner` in the plane z = const; ids of nodes and elements from `first` on, row
  /// by row.
  RuleDeck& plate(std::int64_t first, std::int64_t part, int nx, int ny, const Vector& corner, double dx, double dy) {
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i) node(first + j * (nx + 1) + i, corner + Vector(i * dx, j * dy, 0));
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        const std::int64_t n = first + j * (nx + 1) + i;
        shell(first + j * nx + i, part, {n, n + 1, n + nx + 2, n + nx + 1});
      }
    return *this;
  }
  /// nx x ny x nz bricks of size d from `corner`; ids of nodes and elements from `first` on.
  RuleDeck& block(std::int64_t first, std::int64_t part, int nx, int ny, int nz, const Vector& corner,
                  const Vector& d) {
    const auto id = [&](int i, int j, int k) { return first + (k * (ny + 1) + j) * (nx + 1) + i; };
    for (int k = 0; k <= nz; ++k)
      for (int j = 0; j <= ny; ++j)
        for (int i = 0; i <= nx; ++i) node(id(i, j, k), corner + Vector(i * d[0], j * d[1], k * d[2]));
    std::int64_t element = first;
    for (int k = 0; k < nz; ++k)
      for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i)
          solid(element++, part,
                {id(i, j, k), id(i + 1, j, k), id(i + 1, j + 1, k), id(i, j + 1, k), id(i, j, k + 1),
                 id(i + 1, j, k + 1), id(i + 1, j + 1, k + 1), id(i, j + 1, k + 1)});
    return *this;
  }
  /// Keyword without `*`, then its lines as they stand.
  RuleDeck& raw(const std::string& keyword, const std::string& lines = "") {
    rest_ += "*" + keyword + "\n" + lines;
    if (!lines.empty() && lines.back() != '\n') rest_ += '\n';
    return *this;
  }
  /// A contact with an id and cards 1 to 3; `cards` holds what stands behind card 1.
  RuleDeck& contact(std::int64_t id, const std::string& keyword, const std::string& card1,
                    const std::string& cards = "0.\n1.,1.\n") {
    return raw("CONTACT_" + keyword + "_ID", fmt::format("{},contact {}\n{}\n{}", id, id, card1, cards));
  }
  [[nodiscard]] std::string text() const {
    const auto block = [](const char* keyword, const std::string& lines) {
      return lines.empty() ? std::string() : std::string(keyword) + "\n" + lines;
    };
    return "*KEYWORD\n*MAT_ELASTIC\n1,7.85e-9,210000.,0.3\n*MAT_RIGID\n2,7.85e-9,210000.,0.3\n" + parts_ +
           block("*NODE", nodes_) + block("*ELEMENT_SHELL", shells_) + block("*ELEMENT_SOLID", solids_) +
           block("*ELEMENT_BEAM", beams_) + rest_ + "*END\n";
  }

 private:
  RuleDeck& part(std::int64_t id, std::int64_t material, const std::string& section) {
    parts_ += fmt::format("{}*PART\npart {}\n{},{},{}\n", section, id, id, id, material);
    return *this;
  }
  std::string parts_, nodes_, shells_, solids_, beams_, rest_;
};

/// What one rule finds in a deck; fails the test if the deck cannot be read without errors.
inline Report run_rule(const std::string& rule, const std::string& text, audit::AuditOptions options = {}) {
  options.select = {rule};
  const AuditRun run = run_text(text, options);
  EXPECT_TRUE(clean(run)) << describe(run.diagnostics);
  return run.report;
}
inline Report run_rule(const std::string& rule, const RuleDeck& deck, const audit::AuditOptions& options = {}) {
  return run_rule(rule, deck.text(), options);
}
/// The same for a deck of data/, without ending.
inline Report run_rule_on_example(const std::string& rule, const std::string& name) {
  audit::AuditOptions options;
  options.select = {rule};
  const AuditRun run = run_file(std::string(GAPCHECK_ROOT) + "/data/" + name + ".k", options);
  EXPECT_TRUE(clean(run)) << describe(run.diagnostics);
  return run.report;
}

/// Two shells of 10 x 10 (1, 2) and behind each one of 10 x `width` (3, 4), in contact with themselves.
inline RuleDeck two_densities(double width) {
  RuleDeck deck;
  deck.shell_part(1, 0.1);
  for (int i = 0; i < 3; ++i)
    deck.node(1 + i, {10.0 * i, 0, 0}).node(11 + i, {10.0 * i, 10, 0}).node(21 + i, {10.0 * i, 10 + width, 0});
  for (int i = 0; i < 2; ++i)
    deck.shell(1 + i, 1, {1 + i, 2 + i, 12 + i, 11 + i}).shell(3 + i, 1, {11 + i, 12 + i, 22 + i, 21 + i});
  return deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0");
}

/// The number of the line that is `line`; 0 if there is none.
inline std::uint32_t line_of(const RuleDeck& deck, const std::string& line) {
  const std::string text = "\n" + deck.text();
  const auto at = text.find("\n" + line + "\n");
  EXPECT_NE(at, std::string::npos) << line;
  return at == std::string::npos ? 0U
                                 : static_cast<std::uint32_t>(std::count(text.begin(), text.begin() + at, '\n') + 1);
}

/// How many things a report lists, whatever their kind.
inline std::size_t listed(const Report& report) {
  return report.findings.size() + report.penetrations.size() + report.tie_failures.size();
}

}  // namespace gapcheck::audit_test
