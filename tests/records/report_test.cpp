#include "records/report.hpp"

#include <gtest/gtest.h>

#include <array>
#include <type_traits>

namespace gapcheck::report_test {
namespace {

TEST(Report, AMillionRecordsStaySmall) {
  // Ten million penetrations of a hostile deck must still fit beside the mesh.
  EXPECT_LE(sizeof(Penetration), 256u);
  EXPECT_TRUE(std::is_nothrow_move_constructible_v<Report>);
}

TEST(Report, EveryKindHasItsNumberAndOnlyTheFirstItsDepth) {
  ContactSummary contact;
  for (std::size_t kind = 0; kind < penetration_kinds; ++kind)
    for (std::size_t times = 0; times <= kind; ++times) {
      Penetration record;
      record.kind = static_cast<PenetrationKind>(kind);
      record.depth = 1 + static_cast<double>(kind);
      count(record, contact);
    }
  const auto numbers = [&] {
    return std::array{contact.penetrations,        contact.released,
                      contact.edge_zone,           contact.segment_penetrations,
                      contact.mortar_penetrations, contact.edge_penetrations};
  };
  EXPECT_EQ(numbers(), (std::array<std::uint64_t, 6>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(contact.max_penetration, 1);
  clear_counts(contact);
  EXPECT_EQ(numbers(), (std::array<std::uint64_t, 6>{}));
  EXPECT_EQ(contact.max_penetration, 0);
}

TEST(Report, StartsEmpty) {
  const Report report;
  EXPECT_TRUE(report.penetrations.empty());
  EXPECT_TRUE(report.findings.empty());
  EXPECT_EQ(report.model.nodes, 0u);
  EXPECT_EQ(report.timing.total_s, 0.0);
}

}  // namespace
}  // namespace gapcheck::report_test
