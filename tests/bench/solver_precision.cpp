// Impacts with a closed form under different settings: how wrong, and how long it takes. One line of JSON per run;
// solver_precision.py makes a page of them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "keyword/deck.hpp"
#include "solver/run.hpp"

namespace {

using namespace gapcheck;

// Rods of length 4 and ν = 0: the wave runs with c = √(E/ρ) = 10.
constexpr double young = 400, density = 4, wave = 10, length = 4, speed = 0.01;

struct Setting {
  double tssfac = 0.9, sfs = 1;
  int soft = 0, bsort = 0;
};

/// A rod of n cubes along x, as part and first node id `part` · 1000.
std::string rod(int part, int n, double start) {
  const double h = length / n;
  const int first = part * 1000;
  std::string text = "*NODE\n";
  for (int i = 0; i <= n; ++i)
    for (int c = 0; c < 4; ++c)
      text += fmt::format("{},{:.17g},{},{}\n", first + 4 * i + c, start + i * h, c == 1 || c == 2 ? h : 0.,
                          c >= 2 ? h : 0.);
  text += "*ELEMENT_SOLID\n";
  for (int i = 0; i < n; ++i) {
    text += fmt::format("{},{}", first + i, part);
    for (int c = 0; c < 8; ++c) text += fmt::format(",{}", first + 4 * i + c);
    text += "\n";
  }
  return text + fmt::format("*PART\nrod\n{},1,1\n", part);
}

/// Cards 2, 3, A and B of a contact.
std::string contact_cards(const Setting& setting) {
  return fmt::format("0.\n{0},{0}\n{1},0.1,0,1.025,0.,2,{2}\n0.,0,0,1\n", setting.sfs, setting.soft, setting.bsort);
}

/// A rod hits an equal one at rest, end face on end face.
std::string rods(int n, const Setting& setting) {
  const int a = 1000 + 4 * n, b = 2000;
  return rod(1, n, 0) + rod(2, n, length + 1e-6) +
         fmt::format("*INITIAL_VELOCITY_GENERATION\n1,2,0.,{},0.,0.\n0.,0.,0.,0.,0.,1.\n", speed) +
         fmt::format(
             "*SECTION_SOLID\n1,1\n*MAT_ELASTIC\n1,{},{},0.\n*CONTROL_TERMINATION\n1.1\n"
             "*CONTROL_TIMESTEP\n0.,{}\n",
             density, young, setting.tssfac) +
         fmt::format("*SET_SEGMENT\n1\n{},{},{},{}\n*SET_SEGMENT\n2\n{},{},{},{}\n", a, a + 1, a + 2, a + 3, b, b + 3,
                     b + 2, b + 1) +
         "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n1,2,0,0\n" + contact_cards(setting);
}

/// Two plates of n x n shells, one thrown at the other: they bounce and slide.
std::string plates(int n, const Setting& setting) {
  std::string nodes = "*NODE\n", shells = "*ELEMENT_SHELL\n";
  const auto plate = [&](int part, double size, double z, int id) {
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i)
        nodes += fmt::format("{},{:.17g},{:.17g},{:.17g}\n", id + j * (n + 1) + i, size * i / n, size * j / n,
                             z + 0.003 * std::sin(5.0 * i + 3.0 * j));
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const int a = id + j * (n + 1) + i;
        shells += fmt::format("{},{},{},{},{},{}\n", a, part, a, a + 1, a + n + 2, a + n + 1);
      }
  };
  plate(1, 1, 0, 1);
  plate(2, 0.9, 0.06, 10001);
  return nodes + shells +
         "*PART\np\n1,1,1\n*PART\nq\n2,1,1\n*SECTION_SHELL\n1,2\n0.04\n*MAT_ELASTIC\n1,1.,1000.,0.3\n"
         "*INITIAL_VELOCITY_GENERATION\n2,2,0.,0.3,0.1,-2.\n0.,0.,0.,0.,0.,1.\n*CONTROL_TERMINATION\n0.2\n" +
         fmt::format("*CONTROL_TIMESTEP\n0.,{}\n", setting.tssfac) + "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0,0,2\n" +
         contact_cards(setting);
}

/// What one run gave.
struct Outcome {
  bool ended = true;  ///< at the time that the deck asks for
  double seconds = 0, contact_time = 0, velocity = 0, energy = 0;
  std::uint64_t cycles = 0, searches = 0;
  std::vector<Vector> x;
};

class Watch : public solver::Run::Observer {
 public:
  solver::SolverStatus observe(const solver::Run& run, std::optional<solver::RunEnd>) override {
    const auto contacts = run.contacts();
    if (contacts.empty() || !(contacts[0].state().force_a.norm() > 0)) return {};
    const double time = run.stepper().state().time;
    if (first_ < 0) first_ = time;
    last_ = time;
    return {};
  }
  [[nodiscard]] double contact_time() const { return last_ - first_; }

 private:
  double first_ = -1, last_ = -1;
};

Outcome calculate(const std::string& text) {
  Diagnostics diagnostics;
  auto deck = keyword::read_deck_text(text, "precision.k", {}, diagnostics);
  auto model = model::read_model(deck.value(), diagnostics);
  contact::SurfaceStore surfaces(model.value());
  auto prepared = solver::Run::prepare(model.value(), surfaces, {}, diagnostics);
  if (!prepared) {
    fmt::print(stderr, "{}\n", prepared.error().message);
    std::exit(1);
  }
  solver::Run& run = prepared.value();
  Watch watch;
  const bool ended = run.go(watch) == solver::RunEnd::time;
  const solver::State& state = run.stepper().state();
  Outcome outcome;
  outcome.ended = ended;
  outcome.seconds = run.seconds();
  outcome.contact_time = watch.contact_time();
  double momentum = 0, mass = 0;
  for (std::size_t i = state.x.size() / 2; i < state.x.size(); ++i) {
    momentum += state.mass[i] * state.v[i].x();
    mass += state.mass[i];
  }
  outcome.velocity = momentum / mass;
  outcome.energy = run.stepper().energies().ratio();
  outcome.cycles = state.cycle;
  outcome.searches = run.contact_counters().searches;
  outcome.x = state.x;
  return outcome;
}

/// The fastest of three runs, which give the same.
Outcome fastest(const std::string& text) {
  Outcome best = calculate(text);
  for (int i = 0; i < 2; ++i) best.seconds = std::min(best.seconds, calculate(text).seconds);
  return best;
}

void print_rods(const char* group, double value, const Setting& setting) {
  const Outcome outcome = fastest(rods(40, setting));
  fmt::print(
      "{{\"model\":\"rods\",\"group\":\"{}\",\"value\":{},\"seconds\":{:.4f},\"cycles\":{},\"ended\":{},"
      "\"contact_time\":{:.3e},\"velocity\":{:.3e},\"energy\":{:.3e}}}\n",
      group, value, outcome.seconds, outcome.cycles, outcome.ended, outcome.contact_time / (2 * length / wave) - 1,
      outcome.velocity / speed - 1, outcome.energy - 1);
}

void print_plates(int n) {
  const Outcome always = fastest(plates(n, {0.9, 1, 0, 1}));
  for (const int bsort : {1, 10, 100, 0}) {
    const Outcome outcome = fastest(plates(n, {0.9, 1, 0, bsort}));
    double apart = 0;
    for (std::size_t i = 0; i < always.x.size(); ++i) apart = std::max(apart, (outcome.x[i] - always.x[i]).norm());
    fmt::print(
        "{{\"model\":\"plates\",\"group\":\"search\",\"value\":{},\"seconds\":{:.4f},\"cycles\":{},\"searches\":{},"
        "\"energy\":{:.3e},\"apart\":{:.3e}}}\n",
        bsort, outcome.seconds, outcome.cycles, outcome.searches, outcome.energy - 1, apart);
  }
}

/// Boxes of segments, made larger by a reach, in single precision: which nodes inside the boxes do they miss, and how
/// many do they add, where every step is rounded to the nearest number, and where it is rounded outwards?
void print_boxes(double offset) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  constexpr int count = 2000;
  constexpr double reach = 1e-3;
  constexpr float infinity = std::numeric_limits<float>::infinity();
  std::uint64_t pairs = 0, lost_nearest = 0, lost_outward = 0, more_outward = 0;
  const auto down = [](double a) { return std::nextafterf(static_cast<float>(a), -infinity); };
  const auto up = [](double a) { return std::nextafterf(static_cast<float>(a), infinity); };
  std::vector<double> nodes(count);
  for (double& node : nodes) node = offset + uniform(random);
  for (int i = 0; i < count; ++i) {
    const double low = offset + uniform(random), high = low + 0.01;
    const float near_low = static_cast<float>(low) - static_cast<float>(reach),
                near_high = static_cast<float>(high) + static_cast<float>(reach);
    const float far_low = down(down(low) - up(reach)), far_high = up(up(high) + up(reach));
    for (const double node : nodes) {
      const bool in = node >= low - reach && node <= high + reach;
      const auto single = static_cast<float>(node);
      const bool nearest = single >= near_low && single <= near_high;
      const bool outward = up(node) >= far_low && down(node) <= far_high;
      pairs += in;
      lost_nearest += in && !nearest;
      lost_outward += in && !outward;
      more_outward += outward && !in;
    }
  }
  fmt::print(
      "{{\"model\":\"boxes\",\"group\":\"single\",\"value\":{},\"pairs\":{},\"lost_nearest\":{},\"lost_outward\":{},"
      "\"more_outward\":{}}}\n",
      offset, pairs, lost_nearest, lost_outward, more_outward);
}

}  // namespace

int main() {
  for (const double tssfac : {0.9, 0.67, 0.45, 0.225}) print_rods("TSSFAC", tssfac, {tssfac, 1, 0, 0});
  for (const double sfs : {0.01, 0.1, 0.3, 1.0, 2.0, 3.0, 10.0}) print_rods("SFS", sfs, {0.9, sfs, 0, 0});
  for (const int soft : {0, 1}) print_rods("SFS = 0.01, SOFT", soft, {0.9, 0.01, soft, 0});
  print_plates(24);
  for (const double offset : {0.0, 1e2, 1e4, 1e6}) print_boxes(offset);
  return 0;
}
