#include "scenes/scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenes/plates.hpp"
#include "scenes/random_share.hpp"
#include "scenes/vehicle.hpp"

namespace gapcheck::bench {
namespace {

constexpr std::array<std::string_view, all_scenes.size()> names{"plates",     "airbag",  "vehicle", "tubes",
                                                                "huge-facet", "cluster", "blocks"};

constexpr std::string_view single_surface = R"(*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID
         1all parts
         0         0         5         0
       0.0
       1.0       1.0
)";

/// Everything before the parts: one material and sections 1, 2, … of the thicknesses given.
std::string head(std::initializer_list<double> thicknesses) {
  std::string text =
      "*KEYWORD\n*CONTROL_TERMINATION\n     0.001\n*MAT_ELASTIC\n"
      "         1  7.85E-09  210000.0       0.3\n";
  int section = 0;
  for (const double t : thicknesses)
    text += fmt::format("*SECTION_SHELL\n{:10}         2       1.0         2\n{:10}{:10}{:10}{:10}\n", ++section, t, t,
                        t, t);
  return text;
}

int root(double number) { return std::max(1, static_cast<int>(std::lround(std::sqrt(number)))); }

SceneFacts facts(const DeckWriter& deck, std::uint64_t fewest, std::uint64_t most) {
  return {static_cast<std::uint64_t>(deck.nodes()), static_cast<std::uint64_t>(deck.shells() + deck.bricks()), fewest,
          most};
}

std::uint64_t square(int n) { return static_cast<std::uint64_t>(n) * static_cast<std::uint64_t>(n); }

/// Two plates of n × n elements of that size, 0.7 thicknesses apart; shifted by 0.3 and 0.4 of an element, so that n²
/// nodes of either lie over the other.
void stack_plates(DeckWriter& deck, int n, double size, double thickness) {
  const int lower = deck.part(1), upper = deck.part(1);
  deck.sheet(lower, n, n, [&](int i, int j) { return Vector(size * i, size * j, 0); });
  deck.sheet(upper, n, n, [&](int i, int j) { return Vector(size * (i + 0.3), size * (j + 0.4), 0.7 * thickness); });
}

/// One cloth laid to and fro. Every other layer lies 0.3 and 0.4 of an element aside.
SceneFacts write_airbag(std::uint64_t shells, const DeckSink& sink) {
  constexpr int layers = 40;
  constexpr double size = 5, thickness = 0.5, apart = 0.2, fold = 4;
  const int n = root(static_cast<double>(shells) / layers);
  DeckWriter deck(sink);
  deck.text(head({thickness}));
  deck.text(single_surface);
  const int per_layer = n + 2;  // elements along the cloth; the last two are the fold
  deck.sheet(deck.part(1), layers * per_layer - 2, n, [&](int along, int j) {
    const int layer = along / per_layer, i = along % per_layer;
    const bool back = layer % 2 == 1, tip = i == n + 1;
    const double aside = tip ? 0.5 : back ? 1 : 0;
    const double x = tip ? (back ? -fold : size * n + fold) : size * (back ? n - i : i);
    return Vector(x + 0.3 * size * aside, size * (j + 0.4 * aside), apart * (tip ? layer + 0.5 : layer));
  });
  deck.text("*END\n");
  // Two layers on, where no ring of neighbours reaches, there is cloth over or under every node within 0.4, in the edge
  // zone of its rim at the worst.
  return facts(deck, static_cast<std::uint64_t>(deck.nodes()), static_cast<std::uint64_t>(deck.nodes()));
}

/// Pairs of tubes, one in the other, and of strips, one upon the other. In every eighth pair they penetrate.
SceneFacts write_tubes(std::uint64_t shells, const DeckSink& sink) {
  constexpr double size = 20, radius = 10, pitch = 50, width = 5;
  const Vector along = Vector(2, 2, 1) / 3, across = Vector(1, -2, 2) / 3, up = Vector(2, -1, -2) / 3;
  const int length = static_cast<int>(std::clamp(static_cast<double>(shells) / 200, 5.0, 400.0));
  DeckWriter deck(sink);
  deck.text(head({1}));
  deck.text(single_surface);
  const int side = root(static_cast<double>(shells) / (2 * 8 * length));
  std::uint64_t penetrating = 0;
  for (int pair = 0; static_cast<std::uint64_t>(deck.shells()) < shells; ++pair) {
    const bool strips = pair % 4 == 3, meets = pair % 8 < 2;
    const int around = strips ? 1 : 8, elements = strips ? 4 * length : length;
    const Vector axis = pitch * ((pair % side) * across + (pair / side) * up);
    for (const double out : {0.0, meets ? 0.7 : 4.0}) {
      const int part = deck.part(1), first = deck.nodes() + 1, row = strips ? 2 : around;
      for (int i = 0; i <= elements; ++i)
        for (int k = 0; k < row; ++k) {
          const double angle = 2 * std::numbers::pi * k / around;
          const Vector place = strips ? Vector(width * k * across + out * up)
                                      : Vector((radius + out) * (std::cos(angle) * across + std::sin(angle) * up));
          deck.node(axis + (i + (out > 0 ? 0.3 : 0)) * size * along + place);
        }
      for (int i = 0; i < elements; ++i)
        for (int k = 0; k < around; ++k) {
          const int a = first + i * row + k, b = first + i * row + (k + 1) % row;
          deck.shell(part, {a, b, b + row, a + row});
        }
      if (meets) penetrating += static_cast<std::uint64_t>(row) * static_cast<std::uint64_t>(elements);
    }
  }
  deck.text("*END\n");
  // Of every tube one ring of nodes looks out of the other tube.
  return facts(deck, penetrating, penetrating);
}

SceneFacts write_huge_facet(std::uint64_t shells, const DeckSink& sink) {
  constexpr double size = 5;
  const int n = root(static_cast<double>(shells));
  const double low = -0.1 * size * n, high = 1.1 * size * n;
  DeckWriter deck(sink);
  deck.text(head({1}));
  deck.text(single_surface);
  deck.sheet(deck.part(1), 1, 1, [&](int i, int j) { return Vector(i == 0 ? low : high, j == 0 ? low : high, 0); });
  deck.sheet(deck.part(1), n, n, [&](int i, int j) { return Vector(size * i, size * j, 0.7); });
  deck.text("*END\n");
  return facts(deck, square(n + 1), square(n + 1));
}

SceneFacts write_cluster(std::uint64_t shells, const DeckSink& sink) {
  constexpr double size = 0.1, thickness = 0.02, wide = 1e8, single = 100;
  const int n = root(0.47 * static_cast<double>(shells));
  DeckWriter deck(sink);
  deck.text(head({thickness}));
  deck.text(single_surface);
  stack_plates(deck, n, size, thickness);
  const int part = deck.part(1);
  for (std::uint64_t k = 0; static_cast<std::uint64_t>(deck.shells()) < shells; ++k) {
    const Vector corner =
        (0.01 + 0.98 * Vector(random_share(3 * k), random_share(3 * k + 1), random_share(3 * k + 2)).array()) * wide;
    deck.sheet(part, 1, 1, [&](int i, int j) { return Vector(corner + single * Vector(i, j, 0)); });
  }
  deck.text("*END\n");
  return facts(deck, 2 * square(n), 2 * square(n));
}

/// The upper block is 0.3 and 0.4 of an element aside and 0.06 of one too low: n² nodes of either are in the other.
SceneFacts write_blocks(std::uint64_t bricks, const DeckSink& sink) {
  constexpr double size = 5, sunk = 0.3;
  const int n = std::max(2, static_cast<int>(std::lround(std::cbrt(static_cast<double>(bricks))))), layers = n / 2;
  DeckWriter deck(sink);
  deck.text(
      "*KEYWORD\n*CONTROL_TERMINATION\n     0.001\n*MAT_ELASTIC\n"
      "         1  7.85E-09  210000.0       0.3\n*SECTION_SOLID\n         1         1\n");
  deck.text(single_surface);
  const int lower = deck.part(1), upper = deck.part(1);
  deck.block(lower, n, n, layers, [&](int i, int j, int k) { return Vector(size * i, size * j, size * k); });
  deck.block(upper, n, n, layers, [&](int i, int j, int k) {
    return Vector(size * (i + 0.3), size * (j + 0.4), size * (layers + k) - sunk);
  });
  deck.text("*END\n");
  return facts(deck, 2 * square(n), 2 * square(n));
}

}  // namespace

std::string_view name(SceneKind kind) { return names[static_cast<std::size_t>(kind)]; }

std::optional<SceneKind> scene_kind(std::string_view text) {
  for (const SceneKind kind : all_scenes)
    if (name(kind) == text) return kind;
  return std::nullopt;
}

SceneFacts write_plates(int n, bool stray, const DeckSink& sink) {
  DeckWriter deck(sink);
  deck.text(head({1}));
  deck.text(single_surface);
  stack_plates(deck, n, 5, 1);
  if (stray) deck.sheet(deck.part(1), 1, 1, [](int i, int j) { return Vector(150000 + 5 * i, 5 * j, 0); });
  deck.text("*END\n");
  return facts(deck, 2 * square(n), 2 * square(n));
}

std::string plates_deck(int n, bool stray) {
  std::string text;
  write_plates(n, stray, [&](std::string_view piece) { text += piece; });
  return text;
}

SceneFacts write_scene(SceneKind kind, std::uint64_t elements, const DeckSink& sink) {
  switch (kind) {
    case SceneKind::plates:
      return write_plates(root(static_cast<double>(elements) / 2), false, sink);
    case SceneKind::airbag:
      return write_airbag(elements, sink);
    case SceneKind::vehicle:
      return write_vehicle(elements, sink);
    case SceneKind::tubes:
      return write_tubes(elements, sink);
    case SceneKind::huge_facet:
      return write_huge_facet(elements, sink);
    case SceneKind::cluster:
      return write_cluster(elements, sink);
    case SceneKind::blocks:
      return write_blocks(elements, sink);
  }
  return {};
}

}  // namespace gapcheck::bench
