// The segment that counts for each node, found with pairs that rest and nodes that are followed, is that of all pairs
// decided anew in each cycle.
#include "solver/contact/segment_finder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "contact/surface/contact_surfaces.hpp"
#include "model/read.hpp"
#include "solver/contact/search_margin.hpp"

namespace gapcheck::solver::segment_finder_test {
namespace {

using contact::Hit;
using contact::NodeContact;

/// Boxes of solids and plates of shells, each a part of its own.
struct Stack {
  std::string nodes = "*NODE\n", shells = "*ELEMENT_SHELL\n", solids = "*ELEMENT_SOLID\n", cards;
  std::vector<int> part;  ///< by node
  int elements = 0, parts = 0;

  int add_node(const Vector& at) {
    part.push_back(parts);
    nodes += fmt::format("{},{:.17g},{:.17g},{:.17g}\n", part.size(), at.x(), at.y(), at.z());
    return static_cast<int>(part.size());
  }
  /// n x n x 1 bricks with a corner at `low`.
  void add_box(int n, const Vector& low, double width, double height) {
    ++parts;
    const int first = static_cast<int>(part.size()) + 1, row = n + 1;
    for (int k = 0; k < 2; ++k)
      for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) add_node(low + Vector(width * i / n, width * j / n, height * k));
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const int a = first + j * row + i, up = row * row;
        solids += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", ++elements, parts, a, a + 1, a + 1 + row, a + row,
                              a + up, a + 1 + up, a + 1 + row + up, a + row + up);
      }
    cards += fmt::format("*PART\nbox\n{0},{0},1\n*SECTION_SOLID\n{0},1\n", parts);
  }
  /// n x n shells.
  void add_plate(int n, const Vector& low, double width, double thickness) {
    ++parts;
    const int first = static_cast<int>(part.size()) + 1, row = n + 1;
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) add_node(low + Vector(width * i / n, width * j / n, 0));
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const int a = first + j * row + i;
        shells += fmt::format("{},{},{},{},{},{}\n", ++elements, parts, a, a + 1, a + 1 + row, a + row);
      }
    cards += fmt::format("*PART\nplate\n{0},{0},1\n*SECTION_SHELL\n{0},2\n{1}\n", parts, thickness);
  }
  [[nodiscard]] std::string deck(const std::string& contact) const {
    return nodes + shells + solids + cards + "*MAT_ELASTIC\n1,1.,1000.,0.25\n" + contact;
  }
};

struct Totals {
  std::size_t contacts = 0, behind = 0, followed = 0, asleep = 0, released = 0;
  std::uint64_t decided = 0, candidates = 0;
};

/// One side of a contact whose nodes move at will.
class Side {
 public:
  /// One of `released_of` nodes in contact is released in a cycle.
  Side(const std::string& deck, bool exchanged, int released_of)
      : released_of_(released_of),
        read_(model::read_text(deck)),
        x_(read_.model.mesh.nodes.x),
        movable_(x_.size(), true),
        store_(read_.model),
        masses_(read_.model),
        search_(contact::make_brute_force()),
        ties_(read_.model),
        setting_{read_.model, masses_, *search_, ties_, movable_, shared_},
        pairs_(setting_, ContactIndex{0}, store_.at(ContactIndex{0}), exchanged, x_),
        finder_(pairs_) {
    EXPECT_EQ(read_.errors(), 0U) << read_.text();
    find_candidates();
  }

  [[nodiscard]] std::vector<Vector>& x() { return x_; }
  /// The nodes have moved by at most `way`; every decision is compared.
  void check_cycle(double way, std::mt19937& random, Totals& totals) {
    used_ += 2 * way * rounding_of_motion;
    if (used_ > margin) find_candidates();
    PairCounts counts;
    for (std::size_t first = 0; first < pairs_.places(); first += geometry::FollowedPairs::capacity) {
      const std::size_t last = std::min(pairs_.places(), first + geometry::FollowedPairs::capacity);
      finder_.follow_pairs(first, last, scratch_);
      for (std::size_t place = first; place < last; ++place) check_place(place, random, counts, totals);
    }
    pairs_.clear_lost();
    totals.decided += counts.pairs;
    totals.followed += counts.followed;
    totals.asleep += counts.asleep;
  }

 private:
  static constexpr double margin = 0.15;

  void find_candidates() {
    contact::SweepCounters sweep;
    pairs_.find_candidates(*search_, margin, sweep);
    used_ = 0;
  }

  void check_place(std::size_t place, std::mt19937& random, PairCounts& counts, Totals& totals) {
    const SlotIndex slot = pairs_.slot_at(place);
    std::vector<Hit> hits, measured;
    for (const contact::Candidate& candidate : pairs_.candidates_at(place)) {
      const contact::PairResult pair = contact::decide_pair(pairs_.scene(), slot, candidate.segment);
      const Hit hit{slot, candidate.segment, pair.distance, pair.in_band};
      if (pair.penetrates)
        hits.push_back(hit);
      else if (pairs_.scene().oriented(candidate.segment))
        measured.push_back(hit);
    }
    totals.candidates += pairs_.candidates_at(place).size();
    const std::optional<Hit> expected = contact::choose_hit(pairs_.scene(), hits, measured);
    const bool meets = expected && expected->in_band, was_released = pairs_.node(slot).released();
    const std::optional<NodeMeeting> found = finder_.find_meeting(place, used_, scratch_, counts);
    ASSERT_EQ(found && found->contact, meets) << "slot " << slot.value;
    if (was_released) {
      ASSERT_TRUE(found);
      ASSERT_EQ(found->in_zone, !hits.empty());
    }
    if (!found) return;
    if (meets) {
      ASSERT_EQ(found->contact->segment, expected->segment);
      ASSERT_NEAR(found->contact->distance, expected->distance, 1e-11);
      totals.behind += expected->distance < 0;
      ++totals.contacts;
    }
    remember(slot, *found, std::uniform_int_distribution<int>(1, released_of_)(random) == 1, totals);
  }

  /// As the passes do. `too_deep`: a node in contact is released.
  void remember(SlotIndex slot, const NodeMeeting& meeting, bool too_deep, Totals& totals) {
    if (!meeting.contact && pairs_.known(slot) == nullptr) return;
    TrackedNode& tracked = pairs_.touch(slot);
    if (tracked.released() && meeting.in_zone) return;
    tracked.active = meeting.contact && !too_deep;
    tracked.link = {};
    tracked.memory.state = NodeContact::State::apart;
    if (!meeting.contact) return;
    tracked.memory.state = too_deep ? NodeContact::State::released : NodeContact::State::touching;
    totals.released += too_deep;
    tracked.link.segment = meeting.contact->segment;
    tracked.link.on_face = meeting.contact->on_face;
    tracked.link.s = meeting.contact->s;
    tracked.link.t = meeting.contact->t;
  }

  int released_of_;
  model::Read read_;
  std::vector<Vector> x_;
  std::vector<bool> movable_;
  contact::SurfaceStore store_;
  ContactMasses masses_;
  std::unique_ptr<contact::CandidateSearch> search_;
  contact::TiedPairs ties_;
  SharedTables shared_;
  ContactSetting setting_;
  TrackedPairs pairs_;
  SegmentFinder finder_;
  FinderScratch scratch_;
  double used_ = 0;
};

/// A plate thicker than its elements are wide lies on two boxes, the upper with the mesh of the lower or another one,
/// flush or smaller. The parts creep, turn, vibrate and slide, now into each other and now apart.
Totals run(const std::string& contact, int upper, double shift, bool exchanged, unsigned seed) {
  Stack stack;
  stack.add_box(4, Vector(0, 0, 0), 2, 0.5);
  stack.add_box(upper, Vector(shift, shift, 0.502), shift > 0 ? 1.3 : 2, 0.5);
  stack.add_plate(5, Vector(0.4, 0.4, 1.505), 1.2, 1);
  Side side(stack.deck(contact), exchanged, 20);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1, 1);
  Totals totals;
  std::vector<Vector> creep(4), spin(4);
  for (int cycle = 0; cycle < 300 && !testing::Test::HasFatalFailure(); ++cycle) {
    if (cycle % 25 == 0)
      for (std::size_t p = 1; p <= 3; ++p) {
        const double along = p == 1 ? 1 : -1, way = cycle % 50 == 0 ? 1.2e-3 : -1e-3;
        const double across = cycle % 75 == 0 ? 2e-2 : 2e-3;
        creep[p] = Vector(across * any(random), across * any(random), along * way * std::abs(any(random)));
        spin[p] = 1e-3 * Vector(any(random), any(random), any(random));
      }
    double longest = 0;
    for (std::size_t n = 0; n < side.x().size(); ++n) {
      const auto p = static_cast<std::size_t>(stack.part[n]);
      Vector& x = side.x()[n];
      const Vector step = creep[p] + spin[p].cross(x - Vector(1, 1, 0.7)) +
                          (cycle % 3 == 0 ? 4e-4 : 0) * Vector(any(random), any(random), any(random));
      x += step;
      longest = std::max(longest, step.norm());
    }
    side.check_cycle(longest * (1 + 1e-12), random, totals);
  }
  return totals;
}

/// The upper box and the plate, meshes that match, press on what lies below. Nodes stay over the corners of segments
/// but for tiny ways, different for each of them, so that up to four segments are equally near or nearly so.
Totals press(const std::string& contact, bool exchanged, double dent, unsigned seed) {
  Stack stack;
  stack.add_box(4, Vector(0, 0, 0), 2, 0.5);
  stack.add_box(4, Vector(0, 0, 0.499), 2, 0.5);
  stack.add_plate(4, Vector(0, 0, 1.498), 2, 1);
  Side side(stack.deck(contact), exchanged, 2000);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1, 1), exponent(-13, -4);
  Totals totals;
  for (Vector& x : side.x()) x.z() += dent * any(random);
  for (int cycle = 0; cycle < 300 && !testing::Test::HasFatalFailure(); ++cycle) {
    double longest = 0;
    const double beat = cycle % 20 < 10 ? 1e-5 : -1e-5, tilt = 1e-6 * any(random);
    for (std::size_t n = 0; n < side.x().size(); ++n) {
      Vector& x = side.x()[n];
      const double part = stack.part[n] - 2;
      const Vector step = std::pow(10, exponent(random)) * Vector(any(random), any(random), 0) +
                          Vector(0, 0, part * beat + part * tilt * x.x());
      x += step;
      longest = std::max(longest, step.norm());
    }
    side.check_cycle(longest * (1 + 1e-12), random, totals);
  }
  return totals;
}

class Finder : public testing::TestWithParam<std::pair<const char*, std::string>> {};

TEST_P(Finder, IsThatOfAllPairs) {
  Totals all;
  for (const bool exchanged : {false, true})
    for (const double shift : {0.0, 0.13})
      for (const int upper : {4, 3}) {
        if (exchanged && GetParam().second.find("SINGLE") != std::string::npos) continue;
        const Totals one =
            run(GetParam().second, upper, shift, exchanged, static_cast<unsigned>(upper + 17 * exchanged));
        if (HasFatalFailure()) return;
        all.contacts += one.contacts;
        all.behind += one.behind;
        all.followed += one.followed;
        all.asleep += one.asleep;
        all.released += one.released;
        all.decided += one.decided;
        all.candidates += one.candidates;
      }
  EXPECT_GT(all.contacts, 1000U);
  EXPECT_GT(all.followed, 100U);
  EXPECT_GT(all.asleep, 100U);
  EXPECT_GT(all.released, 10U);
  EXPECT_EQ(all.behind > 0, GetParam().first != std::string("plate_on_boxes"));
  EXPECT_LT(all.decided, all.candidates / 2) << "pairs that cannot touch must rest";
}

TEST_P(Finder, IsThatOfAllPairsWhereMeshesMatch) {
  for (const double dent : {0.0, 1e-7, 1e-4})
    for (const bool exchanged : {false, true}) {
      if (exchanged && GetParam().second.find("SINGLE") != std::string::npos) continue;
      const Totals one = press(GetParam().second, exchanged, dent, 5 + exchanged);
      if (HasFatalFailure()) return;
      if (one.contacts == 0) continue;  // the side without nodes, or whose segments see none
      EXPECT_GT(one.contacts, 1000U);
      EXPECT_GT(one.followed, one.contacts / 2) << dent << ' ' << exchanged << ' ' << one.contacts;
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, Finder,
    testing::Values(
        std::pair{"single", "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n\n\n"},
        std::pair{"two_way", "*SET_PART_LIST\n1\n1,3\n*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n1,2,2,3\n\n\n"},
        std::pair{"plate_on_boxes", "*SET_PART_LIST\n1\n1,2\n*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n3,1,3,2\n\n\n"},
        std::pair{"old_type", "*SET_PART_LIST\n1\n1,3\n*CONTACT_SURFACE_TO_SURFACE\n1,2,2,3\n\n\n"}),
    [](const auto& one) { return std::string(one.param.first); });

}  // namespace
}  // namespace gapcheck::solver::segment_finder_test
