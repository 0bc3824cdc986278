// Two plates of N x N shells, the upper one pressed into the lower one so that every node is in contact; the shell
// cycles per second and the share of contact. With "bricks" first: a block of N x N x N bricks with one point, without
// contact. docs/benchmarks.md says what is compared with what.
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <memory>
#include <string>

#include "base/parallel.hpp"
#include "base/system/memory.hpp"
#include "keyword/deck.hpp"
#include "solver/build/build.hpp"
#include "solver/contact/contact_forces.hpp"
#include "solver/step.hpp"

namespace {

using namespace gapcheck;

/// Presses the plates onto each other.
class Weight : public solver::Force {
 public:
  Weight(std::size_t lower, std::size_t upper, double force) : lower_(lower), upper_(upper), force_(force) {}
  void add(solver::State&, solver::Forces& forces) override {
    for (std::size_t i = 0; i < lower_ + upper_; ++i) forces.force[i].z() += i < lower_ ? force_ : -force_;
  }

 private:
  std::size_t lower_, upper_;
  double force_;
};

/// Plates of 1 x 1, 0.01 apart with shells of 0.0101; `far`: a third plate of N x far shells beside them.
std::string plates(int n, int far) {
  std::string nodes = "*NODE\n", shells = "*ELEMENT_SHELL\n";
  int node = 0, element = 0;
  const auto plate = [&](int part, int columns, double x0, double y0, double z) {
    const int first = node + 1;
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= columns; ++i)
        nodes += fmt::format("{:8}{:16.9f}{:16.9f}{:16.9f}\n", ++node, x0 + 1.0 * i / n, y0 + 1.0 * j / n, z);
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < columns; ++i) {
        const int a = first + j * (columns + 1) + i;
        shells +=
            fmt::format("{:8}{:8}{:8}{:8}{:8}{:8}\n", ++element, part, a, a + 1, a + columns + 2, a + columns + 1);
      }
  };
  plate(1, n, 0, 0, 0);
  plate(2, n, 0.4 / n, 0.3 / n, 0.01);
  if (far > 0) plate(3, far, 100, 0, 0);
  std::string parts;
  for (int p = 1; p <= (far > 0 ? 3 : 2); ++p) parts += fmt::format("*PART\np\n{},1,1\n", p);
  return nodes + shells + parts + "*SECTION_SHELL\n1,2\n0.0101\n*MAT_ELASTIC\n1,7.8e3,2.1e11,0.3\n" +
         "*CONTROL_CONTACT\n0.1,0.\n\n\n1\n*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0,0,2\n\n1.,1.,0.0101\n";
}

/// A block of bricks with one point, elastic.
std::string block(int n) {
  std::string nodes = "*NODE\n", solids = "*ELEMENT_SOLID\n";
  const int row = n + 1;
  int element = 0;
  for (int k = 0; k <= n; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i)
        nodes += fmt::format("{:8}{:16.9f}{:16.9f}{:16.9f}\n", (k * row + j) * row + i + 1, 1.0 * i / n, 1.0 * j / n,
                             1.0 * k / n);
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const int a = (k * row + j) * row + i + 1, b = a + row, c = a + row * row, d = c + row;
        solids += fmt::format("{:8}{:8}{:8}{:8}{:8}{:8}{:8}{:8}{:8}{:8}\n", ++element, 1, a, a + 1, b + 1, b, c, c + 1,
                              d + 1, d);
      }
  return nodes + solids + "*PART\np\n1,1,1\n*SECTION_SOLID\n1,1\n*MAT_ELASTIC\n1,7.8e3,2.1e11,0.3\n";
}

struct Speed {
  double seconds = 0, contact_s = 0;
  std::uint64_t nodes = 0, pairs = 0, followed = 0, searches = 0, touching = 0;
  std::size_t elements = 0;
};

Speed run(const std::string& text, int n, int cycles, bool with_contact) {
  Diagnostics diagnostics;
  auto deck = keyword::read_deck_text(text, "plates.k", {}, diagnostics);
  auto model = model::read_model(deck.value(), diagnostics);
  contact::SurfaceStore surfaces(model.value());
  contact::InitialCounters counters;
  const auto initial = contact::initialise_contacts(model.value(), surfaces, {}, counters);
  auto built = solver::build_structure(model.value(), {}, diagnostics);
  solver::Structure& structure = built.value();
  structure.state.x = initial.x;
  const std::size_t elements = structure.shells.size() + structure.solids.size();
  const auto plate_nodes = static_cast<std::size_t>((n + 1) * (n + 1));
  const double weight = 1e7 / static_cast<double>(plate_nodes);
  solver::Stepper stepper(std::move(structure), {});
  if (with_contact) stepper.add(std::make_unique<Weight>(plate_nodes, plate_nodes, weight));
  solver::ContactForces* contacts = nullptr;
  if (with_contact) {
    auto forces = std::make_unique<solver::ContactForces>(model.value(), surfaces, initial,
                                                          std::vector<bool>(initial.x.size(), true));
    contacts = forces.get();
    stepper.add(std::move(forces));
  }
  for (int i = 0; i < 200; ++i)
    if (!stepper.step().ok()) std::exit(1);
  const auto before = contacts != nullptr ? contacts->counters() : solver::ContactCounters{};
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < cycles; ++i)
    if (const solver::SolverStatus status = stepper.step(); !status.ok()) {
      fmt::print("{}\n", status.error().message);
      std::exit(1);
    }
  Speed result;
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  result.elements = elements;
  if (contacts != nullptr) {
    const auto& after = contacts->counters();
    result.contact_s = after.force_s + after.search_s - before.force_s - before.search_s;
    result.nodes = after.nodes - before.nodes;
    result.pairs = after.pairs - before.pairs;
    result.followed = after.followed - before.followed;
    result.searches = after.searches - before.searches;
    result.touching = contacts->states()[0].touching;
  }
  return result;
}

}  // namespace

int main(int argc, char** argv) {
  const bool bricks = argc > 1 && std::string(argv[1]) == "bricks";
  if (bricks) {
    --argc;
    ++argv;
  }
  if (argc < 3) {
    fmt::print("usage: gapcheck_solver_speed [bricks] N CYCLES [JOBS] [FAR]\n");
    return 2;
  }
  const int n = std::atoi(argv[1]), cycles = std::atoi(argv[2]), jobs = argc > 3 ? std::atoi(argv[3]) : 0;
  const int far = argc > 4 ? std::atoi(argv[4]) : 0;
  gapcheck::system::keep_freed_memory();  // as the program does
  const gapcheck::JobLimit limit(static_cast<std::size_t>(jobs));
  if (bricks) {
    const Speed r = run(block(n), n, cycles, false);
    fmt::print("{} bricks: {:.2f} million element cycles per second\n", r.elements,
               static_cast<double>(r.elements) * cycles / r.seconds / 1e6);
    return 0;
  }
  const std::string text = plates(n, far);
  for (const bool with_contact : {false, true}) {
    const Speed r = run(text, n, cycles, with_contact);
    const double per_cycle = static_cast<double>(cycles);
    fmt::print(
        "{} shells, {}: {:.2f} million shell cycles per second, contact {:.1f} % of the time, {:.0f} nodes and "
        "{:.0f} pairs looked at ({:.0f} followed) and {:.3f} searches per cycle, {} touching\n",
        r.elements, with_contact ? "contact" : "elements alone",
        static_cast<double>(r.elements) * per_cycle / r.seconds / 1e6, 100 * r.contact_s / r.seconds,
        static_cast<double>(r.nodes) / per_cycle, static_cast<double>(r.pairs) / per_cycle,
        static_cast<double>(r.followed) / per_cycle, static_cast<double>(r.searches) / per_cycle, r.touching);
  }
  return 0;
}
