#include "contact/definition/repeated_contacts.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <tuple>

#include "contact/scene.hpp"

namespace gapcheck::contact::repeated_contacts_test {
namespace {

/// Two plates that penetrate, and contacts between them.
Scene plates(int contacts) {
  Scene scene;
  scene.plate(scene.part(1, 1), {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 2, 2);
  scene.plate(scene.part(2, 1), {0.25, 0.25, 0.75}, {1, 0, 0}, {0, 1, 0}, 2, 2);
  for (int i = 0; i < contacts; ++i) {
    model::Contact& contact = scene.contact("AUTOMATIC_SURFACE_TO_SURFACE");
    contact.id = ContactId{10 + i};
    contact.title = fmt::format("number {}", i);
    contact.a = {1, 3, 0, true};
    contact.b = {2, 3, 0, true};
  }
  return scene;
}

TEST(RepeatedContacts, TheSameCardsWhateverTheName) {
  Scene scene = plates(5);
  auto& contacts = scene.model.contacts;
  contacts[2].sst = 0.5;
  contacts[4].b.id = 1;
  constexpr ContactIndex nothing = none<ContactIndex>;
  EXPECT_EQ(repeated_contacts(scene.model),
            (std::vector<ContactIndex>{nothing, ContactIndex{0}, nothing, ContactIndex{0}, nothing}));
  // What is excluded differs from contact to contact.
  scene.model.exclusions.push_back({contacts[1].id.value, {}, {}});
  EXPECT_EQ(repeated_contacts(scene.model)[1], nothing);
}

TEST(RepeatedContacts, AreCountedOnceOnRequest) {
  Scene scene = plates(4);
  SurfaceStore surfaces(scene.model);
  InitialCounters counters;
  InitialOptions options;
  options.nodes_stay = true;
  const InitialState all = initialise_contacts(scene.model, surfaces, options, counters);
  options.repeated = false;
  const InitialState once = initialise_contacts(scene.model, surfaces, options, counters);
  ASSERT_GT(once.penetrations.size(), 0U);
  EXPECT_EQ(all.penetrations.size(), 4 * once.penetrations.size());
  for (const Penetration& p : once.penetrations) EXPECT_EQ(p.contact, 0U);
  ASSERT_EQ(once.notes.size(), all.notes.size() + 1);
  EXPECT_EQ(
      once.notes.back(),
      "3 contacts have the same cards as an earlier one, contact 11 for instance; they find the same nodes, which "
      "are counted once");
  EXPECT_EQ(once.contacts[3].not_checked, "it repeats contact 10");
}

TEST(RepeatedContacts, AreSearchedAgainOnlyIfNodesHaveMoved) {
  Scene same = plates(4), different = plates(4);
  // Without friction its decay has no effect.
  for (std::size_t i = 0; i < 4; ++i) different.model.contacts[i].dc = static_cast<double>(i);
  for (const bool nodes_stay : {true, false}) {
    InitialOptions options;
    options.nodes_stay = nodes_stay;
    InitialCounters counters, all_counters;
    SurfaceStore surfaces(same.model), all_surfaces(different.model);
    const InitialState state = initialise_contacts(same.model, surfaces, options, counters);
    const InitialState all = initialise_contacts(different.model, all_surfaces, options, all_counters);
    EXPECT_EQ(counters.contacts_searched, nodes_stay ? 1U : 2U);
    EXPECT_EQ(all_counters.contacts_searched, 4U);
    EXPECT_EQ(state.x, all.x);
    EXPECT_GT(all.penetrations.size(), 0U);
    ASSERT_EQ(state.penetrations.size(), all.penetrations.size());
    for (std::size_t i = 0; i < all.penetrations.size(); ++i) {
      const Penetration &p = state.penetrations[i], &q = all.penetrations[i];
      EXPECT_EQ(std::tie(p.contact, p.node, p.segment, p.depth, p.outcome),
                std::tie(q.contact, q.node, q.segment, q.depth, q.outcome));
    }
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(state.contacts[i].penetrations, all.contacts[i].penetrations);
      EXPECT_EQ(state.contacts[i].tracked_nodes, all.contacts[i].tracked_nodes);
    }
  }
}

}  // namespace
}  // namespace gapcheck::contact::repeated_contacts_test
