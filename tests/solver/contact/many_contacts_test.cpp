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

}  // namespace
}  // namespace gapcheck::solver::many_contacts_test
