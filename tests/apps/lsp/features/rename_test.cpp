#include <gtest/gtest.h>

#include <string>

#include "apps/lsp/features_deck.hpp"

namespace gapcheck::app::lsp {
namespace {

TEST_F(LspFeatures, Rename) {
  const auto renamed = [&](const Document& document, Place at, const std::string& name) {
    const auto result = ask(document, [&](const Question& q) { return rename(q, at, name); });
    if (!result) return result.error().message;
    std::string all;
    for (const auto& [file, edits] : result.value()["changes"].items())
      for (const json& edit : edits)
        all += place({{"uri", file}, {"range", edit["range"]}}) + " '" + edit["newText"].get<std::string>() + "'\n";
    return all;
  };
  // The lines of elements too, each in its columns.
  EXPECT_EQ(renamed(*main_, {8, 9}, "1001"), "main.k:8:6-10 '1001'\nparts.k:2:6-10 '1001'\nparts.k:12:12-16 '1001'\n");
  EXPECT_EQ(renamed(*parts_, {10, 9}, "77"), "parts.k:2:28-30 '77'\nparts.k:4:28-30 '77'\nparts.k:10:8-10 '77'\n");
  EXPECT_EQ(renamed(*main_, {12, 9}, "tt"), "main.k:2:8-10 'tt'\nmain.k:12:7-10 '&tt'\nmain.k:13:30-37 '&tt+2*&tt'\n");
  EXPECT_EQ(renamed(*main_, {12, 9}, "thick"),
            "line 14 of " + path("main.k") + " has 10 columns for it, too few for &thick+2*&t");
  EXPECT_EQ(renamed(*main_, {8, 9}, "2"), "part 2 is there already, in line 5 of " + path("parts.k"));
  EXPECT_EQ(renamed(*main_, {8, 9}, "x"), "an id is a whole number above 0");
  EXPECT_EQ(renamed(*main_, {8, 9}, "0"), "an id is a whole number above 0");
  EXPECT_EQ(renamed(*main_, {8, 9}, "123456789"),
            "line 13 of " + path("parts.k") + " has 8 columns for it, too few for 123456789");
  EXPECT_EQ(renamed(*parts_, {4, 9}, "9"),
            "line 9 of " + path("main.k") + " gives it by a parameter; change the value of the parameter");
  EXPECT_EQ(renamed(*main_, {0, 2}, "9"), "there is no id or parameter here that can get another name");
  // Lines whose cards are not told apart may name it: no rename is better than half of one.
  const auto with = [&](const std::string& more) {
    Workspace::set_text(*parts_, Text(parts_text + more));
    return renamed(*main_, {8, 9}, "77");
  };
  const std::string why = " may name 1 or 77, in a way that is not understood; change it by hand";
  EXPECT_EQ(with("*ELEMENT_BEAM_SCALR\n       3       2       2       3       4\n             1.0\n"),
            "line 19 of " + path("parts.k") + " in *ELEMENT_BEAM_SCALR" + why);
  EXPECT_EQ(with("*ELEMENT_BEAM_OF_A_KIND_TO_COME\n       3       1       2       3       4\n"),
            "line 18 of " + path("parts.k") + " in *ELEMENT_BEAM_OF_A_KIND_TO_COME" + why);
  EXPECT_EQ(with("*SET_PART_LIST_GENERATE\n        20\n        70        80\n"),
            "line 19 of " + path("parts.k") + " in *SET_PART_LIST_GENERATE" + why);
  EXPECT_EQ(with("*DEFORMABLE_TO_RIGID\n         1\n"),
            "line 18 of " + path("parts.k") + " in *DEFORMABLE_TO_RIGID" + why);
  EXPECT_EQ(with("*DEFORMABLE_TO_RIGID\n        11\n"),
            "main.k:8:8-10 '77'\nparts.k:2:8-10 '77'\nparts.k:12:14-16 '77'\n");
  Workspace::set_text(*parts_, Text("*PARAMETER_EXPRESSION\nR        s 2*t\n" + std::string(parts_text)));
  EXPECT_EQ(renamed(*main_, {12, 9}, "tt"), "line 2 of " + path("parts.k") + " has it without &; change it by hand");
}

/// Of elements with several lines each line is known by those before it; the same number in others stays.
TEST_F(LspFeatures, RenameInElementsWithSeveralLines) {
  const auto with = [&](const std::string& name, const std::string& more, Place at = {2, 9}) {
    Workspace::set_text(*parts_, Text(parts_text + more));
    const auto result = ask(*parts_, [&](const Question& q) { return rename(q, at, name); });
    if (!result) return result.error().message;
    std::string all;
    for (const json& edit : result.value()["changes"][uri("parts.k")])
      if (const int line = edit["range"]["start"]["line"]; line > 15)
        all += std::to_string(line - 16) + ":" + edit["range"]["end"]["character"].dump() + " '" +
               edit["newText"].get<std::string>() + "'\n";
    return all;
  };
  const std::string quad = "       3       1       1       1       1       1\n", ones = "1.0,1.0,1.0,1.0\n";
  const std::string more_quads = quad + ones + quad + ones, part = "1:16 '77'\n3:16 '77'\n";
  EXPECT_EQ(with("77", "*ELEMENT_SHELL_THICKNESS\n" + more_quads), part);
  EXPECT_EQ(with("77", "*ELEMENT_SHELL_OFFSET\n" + more_quads), part);
  EXPECT_EQ(with("77", "*ELEMENT_BEAM_ORIENTATION\n" + more_quads), part);
  EXPECT_EQ(with("77", "*ELEMENT_BEAM_OFFSET\n" + more_quads), part);
  EXPECT_EQ(with("77", "*ELEMENT_TSHELL_BETA\n" + more_quads), part);
  EXPECT_EQ(with("77", "*ELEMENT_DISCRETE_LCO\n" + more_quads), part);
  EXPECT_EQ(with("77", "*ELEMENT_BEAM_PID\n" + quad + "       1       1\n"), "1:16 '77'\n2:8 '77'\n2:16 '77'\n");
  EXPECT_EQ(with("77", "*ELEMENT_SHELL_COMPOSITE\n" + quad + "         1       1.0       45.\n" + quad), part);
  // Solids in one line and in two beside each other, for the part, for a node and for an element.
  const std::string solids =
      "*ELEMENT_SOLID\n       3       1       1       1       1       1       1       1       1       1\n"
      "       4       1\n       1       4       1       4       1       4       1       4\n";
  EXPECT_EQ(with("77", solids), "1:16 '77'\n2:16 '77'\n");
  EXPECT_EQ(with("77", solids, {15, 7}),
            "1:24 '77'\n1:32 '77'\n1:40 '77'\n1:48 '77'\n1:56 '77'\n1:64 '77'\n1:72 '77'\n1:80 '77'\n"
            "3:8 '77'\n3:24 '77'\n3:40 '77'\n3:56 '77'\n");
  EXPECT_EQ(with("77", solids, {18, 7}), "2:8 '77'\n");
  // Nodes that other lines name, and plies, whose materials are no parts.
  EXPECT_EQ(
      with("77", "*ELEMENT_SHELL_DOF\n       3       2       5       5       5\n                       1       5\n",
           {15, 7}),
      "2:24 '77'\n");
  EXPECT_EQ(with("77", "*ELEMENT_SHELL_COMPOSITE\n" + quad + "         5       5.0       45.\n", {10, 9}),
            "2:10 '77'\n");
  // The orientation of a spring is no vector.
  EXPECT_EQ(
      with("77", "*DEFINE_VECTOR\n         9\n*ELEMENT_DISCRETE\n       3       1       1       1       9\n", {17, 9}),
      "1:10 '77'\n");
}

/// Where a line is not known, a parameter in it counts: by its name, and by its value in place of a number.
TEST_F(LspFeatures, RenameKnowsParametersInLinesThatItDoesNotKnow) {
  const auto with = [&](Document& document, Place at, const std::string& more) {
    Workspace::set_text(*parts_, Text(parts_text + more));
    const auto result = ask(document, [&](const Question& q) { return rename(q, at, "77"); });
    return result ? std::string() : result.error().message;
  };
  const std::string inertia = "*ELEMENT_INERTIA_OFFSET\n       3       3\n        5.\n";
  const std::string why = ", in a way that is not understood; change it by hand";
  EXPECT_EQ(with(*parts_, {15, 7}, inertia + "       &t\n"), "");
  EXPECT_EQ(with(*parts_, {13, 7}, inertia + "     &pid\n"),
            "line 20 of " + path("parts.k") + " in *ELEMENT_INERTIA_OFFSET may name 2 or 77" + why);
  Workspace::set_text(*parts_, Text(parts_text + inertia + "     &T+1\n"));
  const auto renamed = ask(*main_, [&](const Question& q) { return rename(q, {2, 9}, "tt"); });
  ASSERT_FALSE(renamed);
  EXPECT_EQ(renamed.error().message,
            "line 20 of " + path("parts.k") +
                " in *ELEMENT_INERTIA_OFFSET has it in a card that is not known; change it by hand");
}

}  // namespace
}  // namespace gapcheck::app::lsp
