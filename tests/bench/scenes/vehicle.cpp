#include "scenes/vehicle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "scenes/random_share.hpp"

namespace gapcheck::bench {
namespace {

constexpr double thickness = 1, cell = 300;
/// Share of the shortest edge that limits the thickness in single-surface contacts.
constexpr double edge_share = 0.4;

struct Size {
  double element;
  double share;  ///< of panels with elements up to this size
};
constexpr std::array sizes{Size{1, 0.015}, Size{2, 0.045}, Size{4, 0.14},  Size{5, 0.33},
                           Size{10, 0.72}, Size{20, 0.9},  Size{50, 0.97}, Size{100, 1}};

/// A square panel about the origin of its frame.
struct Panel {
  double element;
  int count;  ///< shells along an edge
  [[nodiscard]] std::uint64_t shells() const {
    return static_cast<std::uint64_t>(count) * static_cast<std::uint64_t>(count);
  }
  [[nodiscard]] std::uint64_t nodes() const {
    return static_cast<std::uint64_t>(count + 1) * static_cast<std::uint64_t>(count + 1);
  }
  /// Contact thickness in a single-surface contact.
  [[nodiscard]] double limited() const { return std::min(thickness, edge_share * element); }
};

/// The panel drawn, with larger elements if it would have more than `most` shells.
Panel draw(double share, double width, std::uint64_t most) {
  for (const Size& size : sizes) {
    const Panel panel{size.element, std::max(1, static_cast<int>(std::lround(width / size.element)))};
    if (share <= size.share && panel.shells() <= most) return panel;
  }
  return {sizes.back().element, 1};
}

struct Frame {
  Vector centre;
  Eigen::Matrix3d axes;
};

Frame draw_frame(std::uint64_t pair, int side) {
  const auto cells = static_cast<std::uint64_t>(side);
  Eigen::Quaterniond turn(random_share(8 * pair + 2) - 0.5, random_share(8 * pair + 3) - 0.5,
                          random_share(8 * pair + 4) - 0.5, random_share(8 * pair + 5) - 0.5);
  turn.normalize();
  const Vector place(static_cast<double>(pair % cells), static_cast<double>(pair / cells % cells),
                     static_cast<double>(pair / (cells * cells)));
  return {cell * place, turn.toRotationMatrix()};
}

void add_panel(DeckWriter& deck, const Panel& panel, const Frame& frame, double height) {
  const double low = -0.5 * panel.element * panel.count;
  deck.sheet(deck.part(1), panel.count, panel.count, [&](int i, int j) {
    return Vector(frame.centre + frame.axes * Vector(low + panel.element * i, low + panel.element * j, height));
  });
}

constexpr std::string_view vehicle_head = R"(*KEYWORD
*CONTROL_TERMINATION
     0.001
*CONTROL_CONTACT
       0.0       0.0         0         0         0         0         0         0
         0         0         0         0         0         0         0         0
         0         0         0         0         0         0         0         0
         1
*MAT_ELASTIC
         1  7.85E-09  210000.0       0.3
*SECTION_SHELL
         1         2       1.0         2
       1.0       1.0       1.0       1.0
*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID
         1all parts
         0         0         5         0
       0.0
       1.0       1.0
)";

std::string pair_contact(int id, int lower, int upper) {
  return fmt::format(
      "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_ID\n{:10}pair\n{:10}{:10}         3         3\n"
      "       0.0\n       1.0       1.0\n",
      id, upper, lower);
}

}  // namespace

SceneFacts write_vehicle(std::uint64_t shells, const DeckSink& sink) {
  constexpr int most_pair_contacts = 64;
  constexpr double pair_shells = 1340;  // on average
  DeckWriter deck(sink);
  deck.text(vehicle_head);
  const int side = std::max(1, static_cast<int>(std::ceil(std::cbrt(static_cast<double>(shells) / pair_shells))));
  SceneFacts facts;
  int contacts = 1;
  for (std::uint64_t pair = 0; static_cast<std::uint64_t>(deck.shells()) < shells; ++pair) {
    const std::uint64_t rest = shells - static_cast<std::uint64_t>(deck.shells());
    const Panel lower = draw(random_share(8 * pair), 150, rest), upper = draw(random_share(8 * pair + 1), 100, rest);
    const Frame frame = draw_frame(pair, side);
    const bool meets = pair % 8 == 0;
    // The distance of the mid-surfaces, in contact thicknesses of the single surface and, wider, of the pair's contact.
    add_panel(deck, lower, frame, 0);
    add_panel(deck, upper, frame, meets ? 0.7 * 0.5 * (lower.limited() + upper.limited()) : 3 * thickness);
    const bool own = contacts <= most_pair_contacts && pair % 2 == 0;
    if (own) deck.text(pair_contact(++contacts, deck.parts() - 1, deck.parts()));
    if (!meets) continue;
    // All nodes of the upper panel, and those of the lower one that lie under it.
    const std::uint64_t times = own ? 2 : 1;
    facts.fewest_penetrations += times * upper.nodes();
    facts.most_penetrations += times * (upper.nodes() + lower.nodes());
  }
  deck.text("*END\n");
  facts.nodes = static_cast<std::uint64_t>(deck.nodes());
  facts.elements = static_cast<std::uint64_t>(deck.shells());
  return facts;
}

}  // namespace gapcheck::bench
