#include "audit/mesh/element_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "audit/run.hpp"
#include "base/parallel.hpp"
#include "keyword/deck.hpp"

namespace gapcheck::audit::element_mesh_test {
namespace {

constexpr const char* data = GAPCHECK_ROOT "/data/";

model::Model read(const std::string& text) {
  Diagnostics diagnostics;
  const auto deck = keyword::read_deck_text(text, "deck.k", {}, diagnostics);
  return model::read_model(deck.value(), diagnostics).value();
}

ElementMesh mesh_of(const model::Model& model) {
  contact::SurfaceStore surfaces(model);
  return element_mesh(model, surfaces, positions<ContactIndex>(model.contacts.size()).list());
}

void expect_sound(const ElementMesh& mesh) {
  EXPECT_EQ(mesh.node_ids.size(), mesh.x.size());
  for (const Vector& x : mesh.x) EXPECT_TRUE(x.allFinite());
  for (const auto* list : {&mesh.part_ids, &mesh.contact_ids}) EXPECT_EQ(list->size(), mesh.size());
  EXPECT_EQ(mesh.thickness.size(), mesh.size());
  EXPECT_EQ(mesh.kinds.size(), mesh.size());
  EXPECT_EQ(mesh.ends.size(), mesh.size());
  for (const double thickness : mesh.thickness) EXPECT_TRUE(std::isfinite(thickness) && thickness >= 0);
  std::vector<bool> used(mesh.x.size());
  for (std::size_t i = 0; i < mesh.size(); ++i)
    for (const std::uint32_t corner : mesh.corners_of(i)) {
      ASSERT_LT(corner, mesh.x.size());
      used[corner] = true;
    }
  EXPECT_EQ(std::count(used.begin(), used.end(), false), 0);
}

const std::string all_kinds =
    "*KEYWORD\n*PART\nshell\n1,1,1\n*PART\nsolid\n2,2,1\n*SECTION_SHELL\n1\n2.,2.,2.,2.\n*SECTION_SOLID\n2\n"
    "*MAT_ELASTIC\n1,1.,1.,0.3\n*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,1.,1.,0.\n4,0.,1.,0.\n5,0.,0.,1.\n6,1.,0.,1.\n"
    "7,1.,1.,1.\n8,0.,1.,1.\n9,5.,5.,5.\n11,6.,6.,6.\n"
    "*ELEMENT_SHELL\n10,1,1,2,3,4\n*ELEMENT_SOLID\n10,2,1,2,3,4,5,6,7,8\n*ELEMENT_BEAM\n12,1,1,7,11\n"
    "*ELEMENT_SPH\n9,2,1.\n";

TEST(ElementMesh, AllKindsAndOnlyTheirNodes) {
  const ElementMesh mesh = mesh_of(read(all_kinds));
  expect_sound(mesh);
  EXPECT_EQ(mesh.element_ids, (std::vector<std::int64_t>{10, 10, 12, 9}));
  EXPECT_EQ(mesh.part_ids, (std::vector<std::int64_t>{1, 2, 1, 2}));
  EXPECT_EQ(mesh.kinds, (std::vector<MeshElement>{MeshElement::shell, MeshElement::solid, MeshElement::beam,
                                                  MeshElement::particle}));
  EXPECT_EQ(mesh.ends, (std::vector<std::uint64_t>{4, 12, 14, 15}));
  EXPECT_EQ(mesh.node_ids.size(), 9U) << "node 11 only orients the beam";
}

TEST(ElementMesh, ContactAndThickness) {
  const ElementMesh mesh = mesh_of(
      read(all_kinds + "*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n4\n0,0,0,0\n\n\n*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n5\n"
                       "1,0,3,0\n\n0.,0.,3.\n*END\n"));
  expect_sound(mesh);
  EXPECT_EQ(mesh.contact_ids[0], 4);
  EXPECT_EQ(mesh.contact_ids[1], 4);
  EXPECT_EQ(mesh.thickness[0], 3) << "the largest";
  EXPECT_EQ(mesh.thickness[1], 0) << "solids have none";
}

TEST(ElementMesh, WithoutFiniteCoordinates) {
  model::Model model = read(all_kinds);
  model.mesh.nodes.x[6][1] = std::nan("");
  const ElementMesh mesh = mesh_of(model);
  expect_sound(mesh);
  EXPECT_EQ(mesh.element_ids.front(), 10);
  EXPECT_EQ(mesh.left_out, 2U) << "solid and beam";
}

TEST(ElementMesh, OnlyWhereItIsAskedFor) {
  const std::string deck = std::string(data) + "two_plates.k";
  EXPECT_FALSE(audit_test::run_file(deck).report.mesh);
  AuditOptions options;
  options.mesh = true;
  options.select = {"GC5"};
  const Report report = audit_test::run_file(deck, options).report;
  ASSERT_TRUE(report.mesh);
  expect_sound(*report.mesh);
  EXPECT_EQ(report.mesh->size(), 18U);
  EXPECT_EQ(report.mesh->thickness.front(), 1) << "surfaces are built for it where no rule needs them";
}

TEST(ElementMesh, SameForAnyNumberOfThreads) {
  AuditOptions options;
  options.mesh = true;
  for (const auto& entry : std::filesystem::directory_iterator(data)) {
    if (entry.path().extension() != ".k") continue;
    ElementMesh one, four;
    {
      const JobLimit limit(1);
      one = audit_test::run_file(entry.path(), options).report.mesh.value();
    }
    {
      const JobLimit limit(4);
      four = audit_test::run_file(entry.path(), options).report.mesh.value();
    }
    expect_sound(one);
    EXPECT_EQ(one.corners, four.corners);
    EXPECT_EQ(one.contact_ids, four.contact_ids);
    EXPECT_EQ(one.thickness, four.thickness);
  }
}

TEST(HighestSet, OfAllKinds) {
  EXPECT_EQ(highest_set({}), 0);
  const model::Model model = read("*KEYWORD\n*NODE\n1,0.,0.,0.\n*SET_NODE_LIST\n7\n1\n*SET_PART_LIST\n31\n1\n*END\n");
  EXPECT_EQ(highest_set(model.sets), 31);
}

}  // namespace
}  // namespace gapcheck::audit::element_mesh_test
