#include "records/report.hpp"

#include <gtest/gtest.h>

#include <type_traits>

namespace gapcheck {
namespace {

TEST(Report, AMillionRecordsStaySmall) {
  // Ten million penetrations of a hostile deck must still fit beside the mesh.
  EXPECT_LE(sizeof(Penetration), 256u);
  EXPECT_TRUE(std::is_nothrow_move_constructible_v<Report>);
}

TEST(Report, StartsEmpty) {
  const Report report;
  EXPECT_TRUE(report.penetrations.empty());
  EXPECT_TRUE(report.findings.empty());
  EXPECT_EQ(report.model.nodes, 0u);
  EXPECT_EQ(report.timing.total_s, 0.0);
}

}  // namespace
}  // namespace gapcheck
