#include "contact/stiffness/contact_timestep.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string_view>

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

// All shells alike: k = 0.1 K A / d everywhere, with the diagonal d, and a corner node has the mass ρ A t / 4, so
// Δt = √(ρ t d / (0.8 K)).
TEST(ContactTimestep, PlateIsLimitedByItsLowestCorner) {
  Scene scene;
  const PartIndex part = scene.part(7, 0.5);
  scene.material(part, rho, bulk);
  const auto nodes = scene.plate(part, Vector(1, 2, 3), Vector(2, 0, 0), Vector(0, 3, 0), 4, 3);
  scene.contact("AUTOMATIC_SINGLE_SURFACE");
  const auto list = steps(scene);
  ASSERT_EQ(list.size(), 1u);
  EXPECT_DOUBLE_EQ(list[0].timestep, std::sqrt(rho * 0.5 * std::sqrt(13.0) / (0.8 * bulk)));
  EXPECT_EQ(list[0].node, scene.model.mesh.nodes.id[nodes[0].value]);
  EXPECT_EQ(list[0].part, 7);
  EXPECT_EQ(list[0].side, 'A');
  EXPECT_EQ(list[0].type, "13");
}

// Shells thicker than their diagonal: k = 0.1 K A / t. Of a leaning quad the shorter diagonal counts.
TEST(ContactTimestep, ThickShellsByTheirThicknessThinOnesByTheShorterDiagonal) {
  for (const double thickness : {0.5, 5.0}) {
    Scene scene;
    const PartIndex part = scene.part(1, thickness);
    scene.material(part, rho, bulk);
    const auto at = [&](double x, double y) { return scene.node(Vector(x, y, 0)); };
    scene.shell(part, {at(0, 0), at(2, 0), at(3, 2), at(1, 2)});  // A = 4, diagonals √13 and √5
    scene.contact("AUTOMATIC_SINGLE_SURFACE");
    const auto list = steps(scene);
    ASSERT_EQ(list.size(), 1u);
    const double k = 0.1 * bulk * 4 / std::max(thickness, std::sqrt(5.0));
    EXPECT_DOUBLE_EQ(list[0].timestep, std::sqrt(rho * thickness * 4 / 4 / (2 * k)));
  }
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
  // k = 0.1 K A / d with A = 2 and 6, d = √5 and √13
  const double k = 0.1 * bulk * (2 * 2 / std::sqrt(5.0) + 6 * 6 / std::sqrt(13.0)) / (2 + 6);
  EXPECT_EQ(list[0].node, 2);  // b: lighter than e
  EXPECT_DOUBLE_EQ(list[0].timestep, std::sqrt(rho * (2 + 6) / 4 / (2 * k)));
}

// A = 2, t = 1; of the quad n1 n2 n3 n3 the shorter diagonal is 2, so k = 0.1 K at each node. Deformable: a third of
// the mass at each; rigid: a quarter at each listed corner, a half at the third.
TEST(ContactTimestep, TrianglesByTheirListedCorners) {
  for (const bool rigid : {false, true}) {
    Scene scene;
    const PartIndex part = scene.part(1, 1);
    scene.material(part, rho, bulk).rigid = rigid;
    const NodeIndex a = scene.node(Vector(0, 0, 0)), b = scene.node(Vector(2, 0, 0)), c = scene.node(Vector(0, 2, 0));
    scene.shell(part, {a, b, c, c});
    scene.contact("AUTOMATIC_SINGLE_SURFACE");
    const auto list = steps(scene);
    ASSERT_EQ(list.size(), 1u);
    EXPECT_EQ(list[0].node, 1);
    EXPECT_DOUBLE_EQ(list[0].timestep, std::sqrt(rho * 2 * (rigid ? 1 / 4.0 : 1 / 3.0) / (0.2 * bulk)));
  }
}

// A triangle counts twice at its third node and once at the others. Only the shared node is light.
TEST(ContactTimestep, TrianglesCountTwiceAtTheirThirdNode) {
  for (const bool third : {false, true}) {
    Scene scene;
    const PartIndex part = scene.part(1, 1);
    scene.material(part, rho, bulk);
    const auto at = [&](double x, double y) { return scene.node(Vector(x, y, 0)); };
    const NodeIndex shared = at(0, 0), a = at(-1, 0), b = at(-1, -1), c = at(0, -1), d = at(2, 0), e = at(0, 2);
    scene.shell(part, {shared, a, b, c});  // A = 1, diagonals √2
    if (third)
      scene.shell(part, {d, e, shared, shared});  // A = 2; diagonals of the quad: 2 and 2
    else
      scene.shell(part, {shared, d, e, e});  // 2 and √8
    for (const NodeIndex heavy : {a, b, c, d, e}) {
      scene.model.mesh.masses.id.push_back(static_cast<std::int64_t>(heavy.value) + 1);
      scene.model.mesh.masses.nodes.push_back({heavy});
      scene.model.mesh.masses.part.push_back(none<PartIndex>);
      scene.model.mesh.mass_values.push_back(1000);
    }
    scene.contact("AUTOMATIC_SINGLE_SURFACE");
    const auto list = steps(scene);
    ASSERT_EQ(list.size(), 1u);
    const double times = third ? 2 : 1, quad = 0.1 * bulk / std::sqrt(2.0), triangle = 0.1 * bulk * 2 / 2;
    const double k = (1 * quad + times * 2 * triangle) / (1 + times * 2), m = rho * (1 / 4.0 + 2 / 3.0);
    EXPECT_EQ(list[0].node, 1);
    EXPECT_DOUBLE_EQ(list[0].timestep, std::sqrt(m / (2 * k)));
  }
}

// Cubes of 3 and 1 with side B's SFM = 4: m = ρ a³ / 8, k = 0.1 SF K a. Each side of a transducer prints
// √(m M / ((m + M) min(k, K))) with the controlling node of the other; for equal nodes that is √(m / (2 k)).
TEST(ContactTimestep, TransducersWithTwoSidesPrintThePair) {
  Scene scene;
  const PartIndex a = scene.part(1, 0), b = scene.part(2, 0);
  scene.material(a, rho, bulk);
  scene.material(b, rho, bulk);
  scene.brick(a, Vector(0, 0, 0), Vector(3, 3, 3));
  scene.brick(b, Vector(9, 0, 0), Vector(1, 1, 1));
  auto& contact = scene.contact("FORCE_TRANSDUCER");
  contact.a = {1, 3, 0, true};
  contact.b = {2, 3, 0, true};
  contact.sfm = 4;
  const auto list = steps(scene);
  ASSERT_EQ(list.size(), 2u);
  const double m = rho * 27 / 8, other = rho / 8, k = 0.1 * bulk * 3, stiff = 0.4 * bulk;
  const double step = std::sqrt(m * other / ((m + other) * std::min(k, stiff)));
  EXPECT_DOUBLE_EQ(list[0].timestep, step);
  EXPECT_DOUBLE_EQ(list[1].timestep, step);
  contact.b = {0, 3, 0, false};  // one side alone prints as any other contact
  const auto alone = steps(scene);
  ASSERT_EQ(alone.size(), 1u);
  EXPECT_DOUBLE_EQ(alone[0].timestep, std::sqrt(m / (2 * k)));
}

TEST(ContactTimestep, SegmentContactsPrintNone) {
  Scene scene;
  const PartIndex part = scene.part(1, 1);
  scene.material(part, rho, bulk);
  scene.plate(part, Vector(0, 0, 0), Vector(2, 0, 0), Vector(0, 3, 0), 1, 1);
  scene.contact("AUTOMATIC_SINGLE_SURFACE").soft = 2;
  EXPECT_TRUE(steps(scene).empty());
}

// The d3hsp of a run with mortar contacts prints their steps as those of the base type. SOFT = 2 of a type without it
// becomes SOFT = 1, which changes nothing in the print.
TEST(ContactTimestep, MortarContactsAndUnknownSoft2PrintAsTheBaseType) {
  const auto of = [](const char* keyword, int soft) {
    Scene scene;
    const PartIndex part = scene.part(1, 1), other = scene.part(2, 0.7);
    scene.material(part, rho, bulk);
    scene.material(other, rho, bulk);
    scene.plate(part, Vector(0, 0, 0), Vector(2, 0, 0), Vector(0, 3, 0), 1, 1);
    scene.plate(other, Vector(0, 0, 5), Vector(1, 0, 0), Vector(0, 1, 0), 2, 2);
    auto& contact = scene.contact(keyword);
    contact.a = {1, 3, 0, true};
    contact.b = {2, 3, 0, true};
    contact.soft = soft;
    std::vector<double> list;
    for (const SurfaceTimestep& side : steps(scene)) list.push_back(side.timestep);
    return list;
  };
  const std::vector<double> base = of("AUTOMATIC_SURFACE_TO_SURFACE", 0), one_way = of("AUTOMATIC_NODES_TO_SURFACE", 0);
  ASSERT_EQ(base.size(), 2U);
  EXPECT_NE(base[0], base[1]);
  EXPECT_EQ(of("AUTOMATIC_SURFACE_TO_SURFACE_MORTAR", 0), base);
  EXPECT_EQ(of("AUTOMATIC_SURFACE_TO_SURFACE_MORTAR", 2), base);
  EXPECT_TRUE(of("AUTOMATIC_SURFACE_TO_SURFACE", 2).empty());
  ASSERT_EQ(one_way.size(), 2U);
  EXPECT_EQ(of("AUTOMATIC_NODES_TO_SURFACE", 2), one_way);
}

// Contact rules, section 12: beams alone print 1.000E+16 with node 0, also where they are no segments.
TEST(ContactTimestep, BeamsAloneHaveNoNode) {
  for (const char* keyword : {"AUTOMATIC_SURFACE_TO_SURFACE", "AUTOMATIC_GENERAL"}) {
    Scene scene;
    const PartIndex part = scene.part(1, 1), rod = scene.part(2, 0);
    scene.material(part, rho, bulk);
    scene.material(rod, rho, bulk);
    scene.plate(part, Vector(0, 0, 0), Vector(2, 0, 0), Vector(0, 3, 0), 1, 1);
    scene.model.sections.back().kind = model::SectionKind::beam;
    scene.model.sections.back().beam_radius = 1;
    auto& beams = scene.model.mesh.beams;
    beams.id.push_back(1);
    beams.nodes.push_back({scene.node(Vector(0, 0, 9)), scene.node(Vector(5, 0, 9))});
    beams.part.push_back(rod);
    beams.line.push_back(0);
    auto& contact = scene.contact(keyword);
    contact.a = {2, 3, 0, true};
    contact.b = {1, 3, 0, true};
    const auto list = steps(scene);
    ASSERT_EQ(list.size(), keyword == std::string_view("AUTOMATIC_GENERAL") ? 1U : 2U) << keyword;
    EXPECT_EQ(list[0].timestep, 1e16);
    EXPECT_EQ(list[0].node, 0);
    EXPECT_EQ(list.size() == 2, list.back().timestep < 1);
  }
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
  const double diagonal = (Vector(1.1, 0.01, 0) - Vector(0.02, 0.9, 0)).norm();  // the shorter one
  EXPECT_NEAR(many[0].timestep, std::sqrt(rho * 0.3 * diagonal / (0.8 * bulk)), 1e-12);
  EXPECT_NEAR(many[1].timestep, std::sqrt(rho * 0.4 * diagonal / (0.8 * bulk)), 1e-12);
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
  EXPECT_TRUE(thin.unstable[0].alone);
  EXPECT_EQ(thin.unstable[0].limit.node, NodeIndex(0));
  scene.model.sections[0].thickness.fill(0.3);  // the limit grows with the root of the thickness
  const PredictedTimesteps thick = predict();
  ASSERT_EQ(thick.unstable.size(), 1u);  // but only against a node that is as light: by the root of two
  EXPECT_FALSE(thick.unstable[0].alone);
  EXPECT_DOUBLE_EQ(thick.unstable[0].limit.timestep,
                   std::sqrt(2.0) * std::sqrt(rho * 16 * 0.3 / 4 / (0.1 * bulk * 16 / std::sqrt(32.0))));
  scene.model.sections[0].thickness.fill(0.4);
  EXPECT_TRUE(predict().unstable.empty());
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
