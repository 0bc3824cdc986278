#include "report/write/table.hpp"

#include <gtest/gtest.h>

namespace gapcheck::report::table_test {
namespace {

constexpr std::array columns{Column{"id"}, Column{"name", Align::left}, Column{"x"}};

TEST(Table, AlignsToTheWidestCell) {
  const std::array<Row<3>, 2> rows{Row<3>{"1", "a", "0.25"}, Row<3>{"1000", "longer", "-3"}};
  std::string out = "before\n";
  append_table(
      columns, rows.size(), [&](std::size_t i, auto& row) { row = rows[i]; }, "  ", out);
  EXPECT_EQ(out,
            "before\n"
            "    id  name       x\n"
            "     1  a       0.25\n"
            "  1000  longer    -3\n");
}

TEST(Table, NoRowsAndEmptyCells) {
  std::string out;
  append_table(
      columns, 0, [](std::size_t, auto&) { FAIL(); }, "", out);
  EXPECT_EQ(out, "id  name  x\n");
  out.clear();
  append_table(
      columns, 1,
      [](std::size_t, auto& row) {
        row = {"1", "", ""};
      },
      "", out);
  EXPECT_EQ(out, "id  name  x\n 1\n");
}

}  // namespace
}  // namespace gapcheck::report::table_test
