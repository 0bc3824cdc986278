#include "contact/stiffness/contact_timestep.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/parallel.hpp"
#include "contact/scene.hpp"

namespace gapcheck::contact::contact_timestep_test {
namespace {

constexpr double rho = 2, bulk = 600;

std::vector<SurfaceTimestep> steps(const Scene& scene) {
  SurfaceStore surfaces(scene.model);
  const std::vector<ContactIndex> all = positions<ContactIndex>(scene.model.contacts.size()).list();
  return predict_timesteps(scene.model, surfaces, all).timesteps.surface_timesteps;
}

// All shells alike: k = 0.1 K A / t everywhere, and a corner node has the mass ρ A t / 4, so Δt = t √(ρ / (0.8 K)).
TEST(ContactTimestep, PlateIsLimitedByItsLowestCorner) {
  Scene scene;
  const PartIndex part = scene.part(7, 0.5);
  scene.material(part, rho, bulk);
  const auto nodes = scene.plate(part, Vector(1, 2, 3), Vector(2, 0, 0), Vector(0, 3, 0), 4, 3);
  scene.contact("AUTOMATIC_SINGLE_SURFACE");
  const auto list = steps(scene);
  ASSERT_EQ(list.size(), 1u);
  EXPECT_DOUBLE_EQ(list[0].timestep, 0.5 * std::sqrt(rho / (0.8 * bulk)));
  EXPECT_EQ(list[0].node, scene.model.mesh.nodes.id[nodes[0].value]);
  EXPECT_EQ(list[0].part, 7);
  EXPECT_EQ(list[0].side, 'A');
  EXPECT_EQ(list[0].type, "13");
  EXPECT_FALSE(list[0].rough);
}

// A cube of side a: A² / V = a, so Δt = √(ρ a³ / 8 / (2 · 0.1 K a)); side B has SFM = 4 and half the step.
TEST(ContactTimestep, SolidsOnBothSides) {
  Scene scene;
  const PartIndex a = scene.part(1, 0), b = scene.part(2, 0);
  scene.material(a, rho, bulk);
  scene.material(b, rho, bulk);
  scene.brick(a, Vector(0, 0, 0), Vector(3, 3, 3));
  scene.brick(b, Vector(9, 0, 0), Vector(3, 3, 3));
  auto& contact = scene.contact("AUTOMATIC_SURFACE_TO_SURFACE");
  contact.a = {1, 3, 0, true};
  contact.b = {2, 3, 0, true};
  contact.sfm = 4;
  const auto list = steps(scene);
  ASSERT_EQ(list.size(), 2u);
  const double step = std::sqrt(rho * 27 / 8 / (0.2 * bulk * 3));
  EXPECT_DOUBLE_EQ(list[0].timestep, step);
  EXPECT_EQ(list[0].node, 1);
  EXPECT_DOUBLE_EQ(list[1].timestep, step / 2);
  EXPECT_EQ(list[1].node, 9);
  EXPECT_EQ(list[1].side, 'B');
}

// Two shells of different size side by side: k is weighted with A / 4, the mass counts all elements, in the contact or
// not.
TEST(ContactTimestep, WeighsTheSegmentsAndCountsEveryMass) {
  Scene scene;
  const PartIndex part = scene.part(1, 1), other = scene.part(2, 1);
  scene.material(part, rho, bulk);
  scene.material(other, rho, bulk);
  const auto at = [&](double x, double y) { return scene.node(Vector(x, y, 0)); };
  const NodeIndex a = at(0, 0), b = at(1, 0), c = at(4, 0), d = at(0, 2), e = at(1, 2), f = at(4, 2);
  scene.shell(part, {a, b, e, d});
  scene.shell(part, {b, c, f, e});
  for (const NodeIndex n : {a, c, d, f}) {
    scene.model.mesh.masses.id.push_back(static_cast<std::int64_t>(n.value) + 1);
    scene.model.mesh.masses.nodes.push_back({n});
    scene.model.mesh.masses.part.push_back(none<PartIndex>);
    scene.model.mesh.mass_values.push_back(1000);
  }
  const NodeIndex g = at(1, 5), h = at(4, 5);
  scene.shell(other, {e, f, h, g});  // not in the contact: only its mass 2 · 9 / 4 counts at e
  scene.contact("AUTOMATIC_SINGLE_SURFACE").a = {1, 3, 0, true};
  const auto list = steps(scene);
  ASSERT_EQ(list.size(), 1u);
  const double k = 0.1 * bulk * (2 * 2 + 6 * 6) / (2 + 6);  // k = 0.1 K A / t with A = 2 and 6
  EXPECT_EQ(list[0].node, 2);                               // b: lighter than e
  EXPECT_DOUBLE_EQ(list[0].timestep, std::sqrt(rho * (2 + 6) / 4 / (2 * k)));
}

TEST(ContactTimestep, TrianglesAreRough) {
  Scene scene;
  const PartIndex part = scene.part(1, 1);
  scene.material(part, rho, bulk);
  const NodeIndex a = scene.node(Vector(0, 0, 0)), b = scene.node(Vector(2, 0, 0)), c = scene.node(Vector(0, 2, 0));
  scene.shell(part, {a, b, c, c});
  scene.contact("AUTOMATIC_SINGLE_SURFACE");
  const auto list = steps(scene);
  ASSERT_EQ(list.size(), 1u);
  EXPECT_TRUE(list[0].rough);
  EXPECT_DOUBLE_EQ(list[0].timestep, std::sqrt(rho * 2 / 3 / (0.2 * bulk * 2)));
}

TEST(ContactTimestep, NodesAloneAndWeakMaterialsLimitNothing) {
  Scene scene;
  const PartIndex part = scene.part(1, 1);
  scene.material(part, rho, 0);
  const auto nodes = scene.plate(part, Vector(0, 0, 0), Vector(2, 0, 0), Vector(0, 3, 0), 1, 1);
  scene.model.sets.nodes[5].members = {nodes[3], nodes[2]};
  auto& contact = scene.contact("AUTOMATIC_NODES_TO_SURFACE");
  contact.a = {5, 4, 0, true};
  contact.b = {1, 3, 0, true};
  const auto list = steps(scene);
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0].timestep, 1e16);
  EXPECT_EQ(list[0].node, 3);
  EXPECT_EQ(list[1].timestep, 1e16);
  EXPECT_EQ(list[1].node, 1);
}

TEST(ContactTimestep, OnlyPenaltySprings) {
  const auto has = [](const char* keyword) {
    model::Contact contact;
    set_name(std::string("CONTACT_") + keyword, contact);
    return has_timestep(classify(contact));
  };
  for (const char* keyword :
       {"SLIDING_ONLY", "SURFACE_TO_SURFACE", "AUTOMATIC_SURFACE_TO_SURFACE", "FORMING_NODES_TO_SURFACE",
        "AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE", "AUTOMATIC_SINGLE_SURFACE", "FORCE_TRANSDUCER", "AUTOMATIC_GENERAL",
        "TIED_SURFACE_TO_SURFACE_OFFSET", "TIEBREAK_NODES_TO_SURFACE"})
    EXPECT_TRUE(has(keyword)) << keyword;
  for (const char* keyword :
       {"TIED_SURFACE_TO_SURFACE", "TIED_NODES_TO_SURFACE_CONSTRAINED_OFFSET", "TIED_SHELL_EDGE_TO_SURFACE",
        "RIGID_BODY_ONE_WAY_TO_RIGID_BODY", "DRAWBEAD", "NO_SUCH_CONTACT"})
    EXPECT_FALSE(has(keyword)) << keyword;
}

// The controlling node and its value are the same however the surface is cut, and in a small part of a large mesh.
TEST(ContactTimestep, LargeSurfacesAndSmallOnes) {
  Scene scene;
  const PartIndex part = scene.part(1, 0.3), small = scene.part(2, 0.4);
  scene.material(part, rho, bulk);
  scene.material(small, rho, bulk);
  scene.plate(part, Vector(0, 0, 0), Vector(1.1, 0.01, 0), Vector(0.02, 0.9, 0), 300, 200);
  scene.plate(small, Vector(0, 0, 9), Vector(1.1, 0.01, 0), Vector(0.02, 0.9, 0), 3, 2);
  scene.contact("AUTOMATIC_SINGLE_SURFACE");
  scene.contact("AUTOMATIC_SINGLE_SURFACE").a = {2, 3, 0, true};
  scene.contact("AUTOMATIC_SINGLE_SURFACE");
  const auto many = steps(scene);
  ASSERT_EQ(many.size(), 3u);
  EXPECT_NEAR(many[0].timestep, 0.3 * std::sqrt(rho / (0.8 * bulk)), 1e-12);
  EXPECT_NEAR(many[1].timestep, 0.4 * std::sqrt(rho / (0.8 * bulk)), 1e-12);
  EXPECT_EQ(many[1].node, 301 * 201 + 1);
  EXPECT_EQ(many[2].timestep, many[0].timestep);  // nothing is left over from the calls before
  const JobLimit one(1);
  const auto again = steps(scene);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(many[i].timestep, again[i].timestep);
    EXPECT_EQ(many[i].node, again[i].node);
  }
}

// A corner node of thin shells: m = ρ A t / 4, k = 0.1 K A / √(A 2), Δt = 2 √(m / k).
TEST(ContactTimestep, SpringsOfThinShellsMayBeUnstable) {
  Scene scene;
  const PartIndex part = scene.part(1, 0.1);
  scene.material(part, rho, bulk, 1.2 * bulk, 0.3);
  scene.plate(part, Vector(0, 0, 0), Vector(4, 0, 0), Vector(0, 4, 0), 2, 2);
  scene.contact("AUTOMATIC_SINGLE_SURFACE");
  const auto predict = [&] {
    SurfaceStore surfaces(scene.model);
    return predict_timesteps(scene.model, surfaces, std::vector{ContactIndex{0}});
  };
  const PredictedTimesteps thin = predict();
  EXPECT_DOUBLE_EQ(thin.run, 0.9 * 4 * std::sqrt(rho * 0.91 / (1.2 * bulk)));
  ASSERT_EQ(thin.unstable.size(), 1u);
  EXPECT_DOUBLE_EQ(thin.unstable[0].limit.timestep,
                   2 * std::sqrt(rho * 16 * 0.1 / 4 / (0.1 * bulk * 16 / std::sqrt(32.0))));
  EXPECT_EQ(thin.unstable[0].limit.node, NodeIndex(0));
  scene.model.sections[0].thickness.fill(0.3);  // the limit grows with the root of the thickness
  const PredictedTimesteps thick = predict();
  EXPECT_TRUE(thick.unstable.empty());
  EXPECT_LT(thick.timesteps.contact_timestep, thick.run);  // although the solver's cautious number is exceeded
}

// A beam along the edge has a spring of its own in types 26 alone.
TEST(ContactTimestep, BeamsSoftenNothing) {
  const auto predict = [](bool stiffened) {
    Scene scene;
    const PartIndex part = scene.part(1, 0.1);
    scene.material(part, rho, bulk, 1.2 * bulk, 0.3);
    const auto nodes = scene.plate(part, Vector(0, 0, 0), Vector(4, 0, 0), Vector(0, 4, 0), 2, 2);
    const PartIndex rod = scene.part(2, 0);
    scene.model.sections.back().kind = model::SectionKind::beam;
    scene.model.sections.back().beam_radius = 1;
    scene.material(rod, 1e-6 * rho, 1e-6 * bulk);
    if (stiffened) {
      auto& beams = scene.model.mesh.beams;
      beams.id.push_back(1);
      beams.nodes.push_back({nodes[0], nodes[1]});
      beams.part.push_back(rod);
      beams.line.push_back(0);
    }
    scene.contact("AUTOMATIC_SINGLE_SURFACE");
    SurfaceStore surfaces(scene.model);
    return predict_timesteps(scene.model, surfaces, std::vector{ContactIndex{0}}).unstable;
  };
  const auto plain = predict(false), stiffened = predict(true);
  ASSERT_EQ(plain.size(), 1u);
  ASSERT_EQ(stiffened.size(), 1u);
  EXPECT_NEAR(stiffened[0].limit.timestep, plain[0].limit.timestep, 1e-5 * plain[0].limit.timestep);
}

TEST(ContactTimestep, StepOfTheRun) {
  model::Controls controls;
  controls.tssfac = 0.5;
  EXPECT_EQ(run_timestep(controls, 4), 2);
  controls.dt2ms = -8;
  EXPECT_EQ(run_timestep(controls, 4), 4);
  EXPECT_EQ(run_timestep({}, 0), 0);
}

}  // namespace
}  // namespace gapcheck::contact::contact_timestep_test
