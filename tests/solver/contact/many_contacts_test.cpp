// Contacts by the thousand: what each costs must not grow with their number.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "solver/contact_scene.hpp"

namespace gapcheck::solver::many_contacts_test {
namespace {

/// Pairs of single shells, each pair 0.7 apart and 1 thick, far from the others; a contact for each pair.
std::string pairs(int count, const std::string& options) {
  std::string nodes = "*NODE\n", shells = "*ELEMENT_SHELL\n", parts, contacts;
  for (int p = 0; p < 2 * count; ++p) {
    const int n = 10 * p + 1;
    const double x = 100.0 * (p / 2), z = p % 2 == 0 ? 0 : 0.7;
    nodes += fmt::format("{},{},0.,{}\n{},{},0.,{}\n{},{},5.,{}\n{},{},5.,{}\n", n, x, z, n + 1, x + 5, z, n + 2, x + 5,
                         z, n + 3, x, z);
    shells += fmt::format("{},{},{},{},{},{}\n", p + 1, p + 1, n, n + 1, n + 2, n + 3);
    parts += fmt::format("*PART\np\n{},1,1\n", p + 1);
    if (p % 2 == 0)
      contacts += fmt::format("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n{},{},3,3\n\n\n{}", p + 1, p + 2, options);
  }
  return nodes + shells + parts + "*SECTION_SHELL\n1,2\n1.\n*MAT_ELASTIC\n1,1e-9,1000.,0.25\n" + contacts;
}

// With SNLOG = 0 nodes are moved in the first cycle: each contact is searched again for itself alone.
TEST(ManyContacts, AMoveInOneDoesNotSearchTheOthersAgain) {
  const auto candidates = [](int count) {
    ContactScene scene(pairs(count, ""), [&](Structure& s) {
      // Below each other's surfaces, where nothing was tracking them.
      for (std::size_t i = 0; i < s.state.x.size(); ++i)
        if (s.state.x[i].z() > 0.5) s.state.x[i].z() -= 0.5;
    });
    scene.step();
    std::uint64_t moved = 0;
    for (std::size_t i = 0; i < scene.contacts->states().size(); ++i) moved += scene.result(i).moved;
    EXPECT_GE(moved, 4U * static_cast<unsigned>(count));
    return scene.contacts->counters().candidates;
  };
  const std::uint64_t few = candidates(25), many = candidates(100);
  EXPECT_GE(few, 25U * 8);
  EXPECT_LE(many, 5 * few);
}

/// Two plates of 3 x 3 shells, 0.7 apart and 1 thick, in `count` contacts. `differ`: their DC differs, which has no
/// effect without friction.
std::string same_plates(int count, bool differ) {
  std::string nodes = "*NODE\n", shells = "*ELEMENT_SHELL\n", contacts;
  for (const int plate : {0, 1})
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i) {
        const int n = 100 * plate + 4 * j + i + 1;
        nodes += fmt::format("{},{},{},{}\n", n, 5 * i + 0.7 * plate, 5 * j + 0.4 * plate, 0.7 * plate);
        if (i < 3 && j < 3) shells += fmt::format("{},{},{},{},{},{}\n", n, plate + 1, n, n + 1, n + 5, n + 4);
      }
  for (int c = 0; c < count; ++c)
    contacts += fmt::format("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n1,2,3,3\n0.,0.,{}\n\n", differ ? c : 0);
  return nodes + shells +
         "*PART\np\n1,1,1\n*PART\nq\n2,1,1\n*SECTION_SHELL\n1,2\n1.\n*MAT_ELASTIC\n1,1e-9,1000.,0.25\n" + contacts;
}

/// The upper plate flies down; `sunk`: it begins that much lower than the initialisation has left it.
ContactScene::Prepare fly(double sunk) {
  return [sunk](Structure& s) {
    for (std::size_t i = 16; i < s.state.x.size(); ++i) {
      s.state.x[i].z() -= sunk;
      s.state.v[i].z() = -2e4;
    }
  };
}

// Contacts with the same cards are calculated once, and each adds its forces: to the last bit as if each were alone,
// with nodes that one of them moves before the others see them, and without.
TEST(ManyContacts, RepeatedOnesActAsIfEachWereAlone) {
  constexpr int count = 5;
  for (const double sunk : {0.0, 0.5}) {
    ContactScene shared(same_plates(count, false), fly(sunk)), alone(same_plates(count, true), fly(sunk));
    std::uint64_t touched = 0, moved = 0;
    for (int cycle = 0; cycle < 60; ++cycle) {
      shared.step();
      alone.step();
      ASSERT_EQ(shared.state().x, alone.state().x) << sunk << ", cycle " << cycle;
      for (std::size_t c = 0; c < count; ++c) {
        const ContactState &a = shared.result(c), &b = alone.result(c);
        ASSERT_EQ(a.contact.value, c);
        ASSERT_EQ(a.force_a, b.force_a) << sunk << ", cycle " << cycle << ", contact " << c;
        ASSERT_EQ(a.moment_b, b.moment_b);
        ASSERT_EQ(a.energy_a, b.energy_a);
        ASSERT_EQ(a.energy_b, b.energy_b);
        ASSERT_EQ(a.lost, b.lost);
        ASSERT_EQ(a.moved, b.moved);
        ASSERT_EQ(a.touching, b.touching);
        ASSERT_EQ(a.released, b.released);
        ASSERT_EQ(shared.contacts->nodes(c).size(), alone.contacts->nodes(c).size());
        touched += a.touching;
        moved += a.moved;
      }
    }
    EXPECT_GT(touched, 0U);
    EXPECT_EQ(moved > 0, sunk > 0);
  }
}

TEST(ManyContacts, RepeatedOnesAreSearchedOnce) {
  const auto candidates = [](int count) {
    ContactScene scene(same_plates(count, false), fly(0));
    scene.step(3);
    return scene.contacts->counters().candidates;
  };
  // The initialisation moves the nodes of the first one, so it has an interface of its own.
  const std::uint64_t two = candidates(2);
  EXPECT_GT(two, 0U);
  EXPECT_EQ(candidates(20), two);
}

/// Two plates `gap` apart that fly against each other.
ContactScene far_plates(double gap) {
  return ContactScene(same_plates(2, true), [gap](Structure& s) {
    for (std::size_t i = 16; i < s.state.x.size(); ++i) {
      s.state.x[i].z() += gap;
      s.state.v[i].z() = -2e5;
    }
  });
}

// A contact has searches and springs from the moment on at which its sides are near.
TEST(ManyContacts, FarOnesWait) {
  ContactScene scene = far_plates(12);
  scene.step();
  // The first one remembers the nodes that the initialisation has moved.
  EXPECT_EQ(scene.contacts->waiting(), 1U);
  std::uint64_t touched = 0;
  for (int cycle = 0; cycle < 2000 && touched == 0; ++cycle) {
    scene.step();
    touched += scene.result().touching;
  }
  EXPECT_EQ(scene.contacts->waiting(), 0U);
  EXPECT_GT(touched, 0U);
  EXPECT_EQ(scene.result().moved, 0U) << "nodes that were followed are not moved";
  ContactScene near = far_plates(0);
  near.step();
  EXPECT_EQ(near.contacts->waiting(), 0U);
}

}  // namespace
}  // namespace gapcheck::solver::many_contacts_test
