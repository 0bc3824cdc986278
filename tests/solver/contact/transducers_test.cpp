#include "solver/contact/transducers.hpp"

#include <gtest/gtest.h>

#include "solver/contact_scene.hpp"

namespace gapcheck::solver::transducers_test {
namespace {

/// Four shells side by side in z = 0 (part 1: x < 2, part 2: x > 2), and above them one shell of part 3 that overlaps
/// both and comes down. `contacts`: keywords.
std::string plates(const std::string& contacts) {
  std::string deck = "*NODE\n";
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 5; ++i) deck += fmt::format("{},{}.,{}.,0.\n", 1 + i + 5 * j, i, 2 * j);
  deck += "21,0.7,0.4,0.101\n22,3.4,0.4,0.101\n23,3.4,1.6,0.101\n24,0.7,1.6,0.101\n*ELEMENT_SHELL\n";
  for (int i = 0; i < 4; ++i)
    deck += fmt::format("{},{},{},{},{},{}\n", i + 1, i < 2 ? 1 : 2, i + 1, i + 2, i + 7, i + 6);
  deck += "21,3,21,22,23,24\n";
  for (int p = 1; p <= 3; ++p) deck += fmt::format("*PART\np\n{},1,1\n", p);
  return deck +
         "*SECTION_SHELL\n1,2\n0.1,0.1,0.1,0.1\n*MAT_ELASTIC\n1,1e-3,1000.,0.25\n*SET_PART_LIST\n1\n1,2\n"
         "*SET_PART_LIST\n2\n3\n*SET_NODE_LIST\n3\n21,23\n" +
         contacts;
}

std::string transducer(int a, int type_a, int b = 0, int type_b = 0, const std::string& form = "_PENALTY") {
  return "*CONTACT_FORCE_TRANSDUCER" + form + fmt::format("\n{},{},{},{}\n", a, b, type_a, type_b);
}

const std::string global = "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0,0,5,0\n0.3\n\n";
const std::string old_pair = "*CONTACT_SURFACE_TO_SURFACE\n1,2,2,2\n\n0.,0.,0.1,0.1\n";

struct Transduced {
  explicit Transduced(const std::string& contacts)
      : scene(plates(contacts), [](Structure& structure) {
          for (std::size_t i = 10; i < 14; ++i) structure.state.v[i] = {0.3, 0.1, -1};
        }) {}
  /// Steps until the upper shell touches.
  void run() {
    // Half steps: forces and positions are of the same time.
    ASSERT_TRUE(scene.stepper->begin_step().ok());
    for (int i = 0; i < 200 && links().size() < 4; ++i) {
      scene.stepper->end_step();
      ASSERT_TRUE(scene.stepper->begin_step().ok());
    }
    ASSERT_GE(links().size(), 4u) << "all upper nodes must touch";
    views.clear();
    for (std::size_t i = 0; i < scene.contacts->states().size(); ++i) views.push_back({scene.contacts, i});
    sums = Transducers(scene.read.model, scene.surfaces).measure(views, scene.state());
  }
  [[nodiscard]] std::vector<ContactLink> links() const {
    std::vector<ContactLink> all;
    for (std::size_t i = 0; i < scene.contacts->states().size(); ++i) scene.contacts->links(i, all);
    return all;
  }
  /// Sum of the forces that the links put on nodes from `first` to `last` (positions).
  [[nodiscard]] Vector on_nodes(std::uint32_t first, std::uint32_t last) const {
    std::vector<Vector> force(scene.state().x.size(), Vector::Zero());
    for (const ContactLink& link : links())
      for (std::size_t i = 0; i < 4; ++i) {
        force[link.tracked.nodes[i].value] += link.tracked.weights[i] * link.force;
        force[link.reference.nodes[i].value] -= link.reference.weights[i] * link.force;
      }
    Vector sum = Vector::Zero();
    for (std::uint32_t i = first; i <= last; ++i) sum += force[i];
    return sum;
  }
  ContactScene scene;
  std::vector<ContactView> views;
  std::vector<ContactState> sums;
};

void expect_near(const Vector& a, const Vector& b) { EXPECT_LE((a - b).norm(), 1e-10 * b.norm()); }

TEST(Transducers, OneSurfaceIsTheSumOfTheForcesOnItsNodes) {
  Transduced t(global + transducer(3, 3) + transducer(1, 2) + transducer(0, 5));
  t.run();
  ASSERT_EQ(t.sums.size(), 3u);
  const Vector upper = t.on_nodes(10, 13);
  EXPECT_GT(upper.z(), 0);
  EXPECT_NE(upper.x(), 0) << "friction is in it";
  expect_near(t.sums[0].force_a, upper);
  expect_near(t.sums[1].force_a, -upper);
  EXPECT_LE(t.sums[2].force_a.norm(), 1e-12 * upper.norm()) << "all forces of a contact are in balance";
  Vector couples = Vector::Zero();  // friction acts on both mid-surfaces
  for (const ContactLink& link : t.links())
    couples += (link.tracked.of(t.scene.state().x) - link.reference.of(t.scene.state().x)).cross(link.force);
  expect_near(t.sums[2].moment_a, couples);
  EXPECT_EQ(t.sums[0].force_b, Vector::Zero());
  EXPECT_EQ(t.sums[0].contact, ContactIndex{1});
}

TEST(Transducers, TwoSurfacesKeepTheForcesBetweenThem) {
  Transduced t(global + transducer(3, 3, 1, 3) + transducer(2, 3, 3, 3) + transducer(1, 3, 2, 3));
  t.run();
  const Vector upper = t.on_nodes(10, 13);
  expect_near(t.sums[0].force_a + t.sums[1].force_b, upper);
  EXPECT_GT(t.sums[0].force_a.norm(), 0.01 * upper.norm());
  EXPECT_GT(t.sums[1].force_a.norm(), 0.01 * upper.norm());
  EXPECT_EQ(t.sums[0].force_a, Vector(-t.sums[0].force_b));
  EXPECT_EQ(t.sums[2].force_a, Vector::Zero()) << "parts 1 and 2 do not touch";
}

TEST(Transducers, AForceGoesToTheFirstOfTwoSurfaceTransducersOnly) {
  const std::string both = global + transducer(3, 3, 1, 2) + transducer(3, 3, 1, 3);
  Transduced first(both), all("*CONTROL_CONTACT\n\n\n\n\n\n0,0,0,0,1\n" + both);
  first.run();
  all.run();
  EXPECT_EQ(first.sums[1].force_a, Vector::Zero());
  ASSERT_EQ(all.scene.read.model.controls.ftall, 1);
  EXPECT_GT(all.sums[1].force_a.norm(), 0);
  expect_near(all.sums[0].force_a, first.sums[0].force_a);
}

TEST(Transducers, ContactsThatAreNotAutomaticDoNotTellTheirSurfaces) {
  Transduced t(old_pair + transducer(3, 3, 1, 2) + transducer(3, 3) + transducer(3, 3, 0, 0, "_CONSTRAINT"));
  t.run();
  EXPECT_EQ(t.sums[0].force_a, Vector::Zero());
  expect_near(t.sums[1].force_a, t.on_nodes(10, 13));
  expect_near(t.sums[1].force_a, -t.scene.result().force_a);
  EXPECT_EQ(t.sums[2].force_a, Vector::Zero()) << "penalty forces are not for _CONSTRAINT";
}

TEST(Transducers, NodeSetsAndSurfacesOfNothing) {
  Transduced t(global + transducer(3, 4) + transducer(99, 3));
  t.run();
  expect_near(t.sums[0].force_a, t.on_nodes(10, 10) + t.on_nodes(12, 12));
  EXPECT_EQ(t.sums[1].force_a, Vector::Zero());
}

TEST(Transducers, ResultantsOfAPairAreItsForcesAndMoments) {
  Transduced t(old_pair);
  t.run();
  Vector moment = Vector::Zero();
  for (const ContactLink& link : t.links()) {
    const Vector arm = link.tracked.of(t.scene.state().x);
    moment +=
        (link.exchanged ? -1 : 1) * (link.exchanged ? link.reference.of(t.scene.state().x) : arm).cross(link.force);
  }
  expect_near(t.scene.result().moment_a, moment);
  EXPECT_GT(moment.norm(), 0);
  Vector other = Vector::Zero();
  for (const ContactLink& link : t.links()) {
    const ContactPoint& on_b = link.exchanged ? link.tracked : link.reference;
    other += (link.exchanged ? 1 : -1) * on_b.of(t.scene.state().x).cross(link.force);
  }
  expect_near(t.scene.result().moment_b, other);
}

}  // namespace
}  // namespace gapcheck::solver::transducers_test
