#include "lsp/features/features.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>

#include "apps/lsp/features_deck.hpp"

namespace gapcheck::app::lsp {
namespace {

using Strings = std::vector<std::string>;

TEST_F(LspFeatures, HoverOfFields) {
  EXPECT_EQ(hovered(*main_, {12, 9}),
            "**FS**, card 2 of *CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n\ncolumns 1–10, number\n\n`&t` = 0.5\n");
  EXPECT_EQ(hovered(*main_, {13, 33}),
            "**SBST**, card 3 of *CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n\ncolumns 31–40, number\n\n`&t+2*&t` = 1.5\n");
  EXPECT_EQ(
      hovered(*main_, {13, 1}),
      "**SFSA**, card 3 of *CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n\ncolumns 1–10, number\n\nblank: the default 1\n");
  EXPECT_EQ(hovered(*main_, {11, 9}),
            "**SURFA**, card 1 of *CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n\ncolumns 1–10, whole number\n\n`7`\n\n"
            "set of parts 7 `all plates`, main.k line 8\n");
  EXPECT_EQ(hovered(*main_, {11, 29}),
            "**SURFATYP**, card 1 of *CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n\ncolumns 21–30, whole number\n\n`2`\n\n"
            "a set of parts\n");
  EXPECT_EQ(hovered(*main_, {8, 18}),
            "**PARTS**, card 2 of *SET_PART_LIST_TITLE\n\ncolumns 11–20, id of a part\n\n`&pid` = 2\n\n"
            "part 2 `upper plate`, parts.k line 5\n");
  EXPECT_EQ(hovered(*parts_, {7, 5}), "**T2**, card 2 of *SECTION_SHELL\n\nvalue 2 of the line, number\n\n`1.0`\n");
  EXPECT_EQ(hovered(*parts_, {4, 29}),
            "**MID**, card 1.2 of *PART\n\ncolumns 21–30, id of a material or an equation of state\n\n`5`\n\n"
            "material 5 `steel`, parts.k line 11\n");
  EXPECT_EQ(hovered(*main_, {99, 0}), "");
}

/// Hover knows the fields of every keyword that has card layouts: those of all cards that its name asks for.
TEST_F(LspFeatures, HoverOfEveryFieldOfEveryLayout) {
  std::size_t keywords = 0, fields = 0;
  for (const std::string_view name : keyword::layout_names("")) {
    // *CONTACT holds all cards of all contacts and is no keyword; *END and another one have none.
    if (name == "CONTACT" || keyword::find_layout(name)->cards.empty()) continue;
    ++keywords;
    std::string text = "*" + std::string(name) + "\n";
    for (int i = 0; i < 20; ++i) text += std::string(260, ' ') + "\n";
    Document& document = workspace_.open(uri("new.k"), 1, text);
    const CardOrder order = card_order(*document.text, document.outline->front());
    EXPECT_FALSE(order.head.empty() && order.cycle.empty()) << name;
    for (std::uint32_t row = 0; row < order.head.size() + order.cycle.size(); ++row) {
      const keyword::CardLayout* card = order.at(row);
      for (std::size_t i = 0; card != nullptr && i < card->fields.size(); ++i) {
        if (card->fields[i].name == "unused") continue;
        ++fields;
        std::string field = card->fields[i].name;
        for (char& c : field) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
        const std::string said = hovered(document, {row + 1, card->fields[i].column});
        EXPECT_TRUE(said.starts_with("**" + field + "**, ")) << name << " line " << row + 1 << ": " << said;
      }
    }
  }
  EXPECT_GT(keywords, 850U);
  EXPECT_GT(fields, 15'000U);
  RecordProperty("keywords", static_cast<int>(keywords));
  RecordProperty("fields", static_cast<int>(fields));
}

TEST_F(LspFeatures, HoverOfKeywords) {
  const std::string contact = hovered(*main_, {9, 4});
  EXPECT_TRUE(
      contact.starts_with("***CONTACT_AUTOMATIC_SINGLE_SURFACE_ID**\n\ncontact type 13, one surface against "
                          "itself\n\n- card of ID: CID HEADING\n- card 1: SURFA SURFB"))
      << contact;
  EXPECT_NE(hovered(*parts_, {0, 1}).find("- card 1.2, repeated: PID SECID MID"), std::string::npos);
}

TEST_F(LspFeatures, Completion) {
  const Strings names = completed("*set_part_l");
  EXPECT_EQ(names.front(), "*SET_PART_LIST");
  EXPECT_EQ(completed("*SECTION_SHELL_").front(), "*SECTION_SHELL_TITLE");
  EXPECT_EQ(completed("*SECTION_SHELL_EF"), Strings({"*SECTION_SHELL_EFG"}));
  const Strings options = completed("*CONTACT_AUTOMATIC_GENERAL_");
  for (const char* option : {"ID", "TITLE", "MPP"})
    EXPECT_EQ(std::count(options.begin(), options.end(), std::string("*CONTACT_AUTOMATIC_GENERAL_") + option), 1)
        << option;
  EXPECT_EQ(completed("*CONTACT_AUTOMATIC_GENERAL_MP"), Strings({"*CONTACT_AUTOMATIC_GENERAL_MPP"}));
  EXPECT_TRUE(completed("SET").empty());
  EXPECT_TRUE(completed("$*SET").empty());
}

TEST_F(LspFeatures, DefinitionsAndReferences) {
  EXPECT_EQ(defined(*main_, {4, 2}), "parts.k:0:0-0");
  EXPECT_EQ(defined(*main_, {8, 9}), "parts.k:2:9-10");
  EXPECT_EQ(defined(*main_, {11, 10}), "main.k:7:9-10");
  EXPECT_EQ(defined(*main_, {12, 9}), "main.k:2:9-10");
  EXPECT_EQ(defined(*parts_, {2, 20}), "parts.k:6:9-10");
  EXPECT_EQ(defined(*parts_, {2, 30}), "parts.k:10:9-10");
  EXPECT_EQ(defined(*parts_, {12, 24}), "parts.k:15:7-8");  // a node
  EXPECT_EQ(defined(*parts_, {12, 16}), "parts.k:2:9-10");  // the part of an element
  EXPECT_EQ(referenced(*parts_, {2, 10}), Strings({"main.k:8:9-10", "parts.k:2:9-10"}));
  EXPECT_EQ(referenced(*parts_, {6, 10}), Strings({"parts.k:2:19-20", "parts.k:4:19-20", "parts.k:6:9-10"}));
  EXPECT_EQ(referenced(*main_, {2, 9}),
            Strings({"main.k:12:9-10", "main.k:13:31-32", "main.k:13:36-37", "main.k:2:9-10"}));
  EXPECT_EQ(referenced(*parts_, {15, 7}), Strings({"parts.k:12:23-24", "parts.k:13:23-24", "parts.k:15:7-8"}));
}

TEST_F(LspFeatures, Outline) {
  const json symbols = ask(*parts_, [](const Question& q) { return document_symbols(q); });
  ASSERT_EQ(symbols.size(), 5U);
  EXPECT_EQ(symbols[0]["name"], "*PART");
  ASSERT_EQ(symbols[0]["children"].size(), 2U);
  EXPECT_EQ(symbols[0]["children"][1]["name"], "part 2");
  EXPECT_EQ(symbols[0]["children"][1]["detail"], "upper plate");
  EXPECT_EQ(symbols[2]["detail"], "material 5 steel");
  EXPECT_EQ(symbols[0]["range"]["end"]["line"], 4);
  const json folds = ask(*parts_, [](const Question& q) { return folding_ranges(q); });
  ASSERT_EQ(folds.size(), 5U);
  EXPECT_EQ(folds[3]["startLine"], 11);
  EXPECT_EQ(folds[3]["endLine"], 13);
}

TEST_F(LspFeatures, FormattingOfCards) {
  Document& document = workspace_.open(uri("new.k"), 1,
                                       "*SECTION_SHELL\n4,2\n 1.0 ,1.0,,1.0\n$ 1,2\n*PART\na, b\n1     2      3\n"
                                       "*NODE\n1,0.5,-1e-3,12345678901234567\n2,1,1,1\n");
  const json edits = ask(document, [](const Question& q) { return format_lines(q, 0, 100); });
  Strings lines;
  for (const json& edit : edits)
    lines.push_back(edit["range"]["start"]["line"].dump() + ":" + edit["newText"].get<std::string>());
  EXPECT_EQ(lines, Strings({"1:         4         2",                      // free format
                            "2:       1.0       1.0                 1.0",  // a blank field
                            "9:       2               1               1               1"}));
  // In a line with a number too long for its columns, and one with a field across columns, nothing changes.
  EXPECT_TRUE(ask(document, [](const Question& q) { return format_lines(q, 3, 9); }).empty());
}

/// The second element of a keyword with two lines each has the cards of the first.
TEST_F(LspFeatures, ElementsWithSeveralLines) {
  Document& document = workspace_.open(
      uri("new.k"), 1, "*ELEMENT_SHELL_THICKNESS\n1,1,1,2,3,4\n1.,1.,1.,1.\n2,1,1,2,3,4\n.5,.5,.5,.5\n");
  const std::string quad = "       1       1       2       3       4", thick(14, ' ');
  const auto lines = [&](std::uint32_t first) {
    Strings texts;
    for (const json& edit : ask(document, [&](const Question& q) { return format_lines(q, first, 100); }))
      texts.push_back(edit["newText"]);
    return texts;
  };
  const Strings second{"       2" + quad, thick + ".5" + thick + ".5" + thick + ".5" + thick + ".5"};
  EXPECT_EQ(lines(3), second);
  ASSERT_EQ(lines(0).size(), 4U);
  EXPECT_EQ(lines(0)[2], second[0]);
  EXPECT_TRUE(hovered(document, {3, 2}).starts_with("**PID**, card 1 of *ELEMENT_SHELL_THICKNESS\n\nvalue 2 of"));
  EXPECT_TRUE(hovered(document, {4, 0}).starts_with("**THIC1**, card 1.2 of *ELEMENT_SHELL_THICKNESS\n\nvalue 1 of"));
}

TEST_F(LspFeatures, CodeActions) {
  Document& document =
      workspace_.open(uri("new.k"), 1, "*SETT_PART_LIST\n1\n*CONTACT_AUTOMATIC_SINGLE_SURFACE\n         0\n*END\n");
  const std::vector<LineFinding> findings{{2, Severity::warning, "GC101", "deep", 4, 12, 1, 0, true}};
  const auto actions = [&](std::uint32_t line) {
    return ask(document, [&](const Question& q) { return code_actions(q, findings, line, line + 1); });
  };
  const json name = actions(0);
  ASSERT_EQ(name.size(), 1U);
  EXPECT_EQ(name[0]["title"], "Change to *SET_PART_LIST");
  EXPECT_EQ(name[0]["edit"]["changes"][document.uri][0]["newText"], "SET_PART_LIST");
  const json contact = actions(2);
  ASSERT_EQ(contact.size(), 3U);
  const std::string cards = contact[0]["edit"]["changes"][document.uri][0]["newText"];
  EXPECT_TRUE(
      cards.starts_with("$#      fs        fd        dc        vc       vdc    penchk        bt        dt\n\n$#"))
      << cards;
  EXPECT_EQ(std::count(cards.begin(), cards.end(), '\n'), 4);
  EXPECT_EQ(contact[0]["edit"]["changes"][document.uri][0]["range"]["start"]["line"], 4);
  EXPECT_EQ(contact[1]["edit"]["changes"][document.uri][0]["newText"],
            "$ gapcheck: ignore GC101 contact=4 part=1 node=12 because \n");
  EXPECT_EQ(contact[2]["command"]["command"], "gapcheck.fix");
}

/// What code actions add are whole lines that end as those of the text do, also behind a last line without an end.
TEST_F(LspFeatures, CodeActionsKeepLineEnds) {
  const std::string cards = "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n         0\n         0.1\n";
  const auto with = [](std::string text, std::string_view line_end) {
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + line_end.size()))
      text.replace(at, 1, line_end);
    return text;
  };
  const auto edited = [&](const std::string& text, std::size_t action) {
    Document& document = workspace_.open(uri("new.k"), 1, text);
    const std::vector<LineFinding> findings{{1, Severity::warning, "GC101", "deep", 4}};
    const json actions = ask(document, [&](const Question& q) { return code_actions(q, findings, 1, 2); });
    const json& edit = actions[action]["edit"]["changes"][document.uri][0];
    Place begin, end;
    EXPECT_TRUE(read_place(edit["range"]["start"], *document.text, Encoding::utf16, begin));
    EXPECT_TRUE(read_place(edit["range"]["end"], *document.text, Encoding::utf16, end));
    return document.text->edited(begin, end, edit["newText"].get<std::string>()).bytes();
  };
  const std::string whole = edited(cards, 0);
  EXPECT_TRUE(whole.starts_with(cards + "$#    sfsa")) << whole;
  EXPECT_TRUE(whole.ends_with("\n\n")) << whole;
  const std::string open_end = cards.substr(0, cards.size() - 1);
  EXPECT_EQ(edited(open_end, 0), whole.substr(0, whole.size() - 1)) << "without the last line end";
  for (const std::size_t action : {0U, 1U}) {
    EXPECT_EQ(edited(with(cards, "\r\n"), action), with(edited(cards, action), "\r\n")) << action;
    EXPECT_EQ(edited(with(open_end, "\r\n"), action), with(edited(open_end, action), "\r\n")) << action;
  }
}

TEST_F(LspFeatures, ParametersOfAnEditorThatHasNotSaved) {
  const std::string text = std::string(main_text).replace(std::string(main_text).find("0.5"), 3, "0.7");
  Workspace::set_text(*main_, Text(text));
  main_->changed = true;
  workspace_.set_deck(path("main.k"), deck_for_editor(path("main.k"), {}, workspace_.changed_texts()));
  EXPECT_NE(hovered(*main_, {12, 9}).find("`&t` = 0.7"), std::string::npos);
}

TEST_F(LspFeatures, FindingsMoveWithTheirLines) {
  Audited audited;
  for (const std::uint32_t line : {1U, 5U, 9U})
    audited.findings[path("main.k")].push_back({line, Severity::note, "GC1", "a finding " + std::to_string(line)});
  EXPECT_EQ(workspace_.set_findings(path("main.k"), audited), std::set<std::string>{path("main.k")});
  const auto after = [&](Place begin, Place end, std::uint32_t added) {
    workspace_.move_findings(*main_, begin, end, added);
    std::vector<std::uint32_t> lines;
    for (const LineFinding& finding : workspace_.findings(path("main.k"))) lines.push_back(finding.line);
    return lines;
  };
  using Lines = std::vector<std::uint32_t>;
  EXPECT_EQ(after({3, 4}, {3, 4}, 2), (Lines{1, 7, 11}));  // two lines more
  EXPECT_EQ(after({0, 1}, {2, 1}, 0), (Lines{0, 5, 9}));   // two lines less
  EXPECT_EQ(after({5, 0}, {5, 0}, 1), (Lines{0, 6, 10}));  // a line in front of the one of the finding
  EXPECT_EQ(after({6, 3}, {6, 3}, 1), (Lines{0, 6, 11}));  // the line of the finding is cut in two
  EXPECT_EQ(after({5, 8}, {6, 0}, 0), (Lines{0, 5, 10}));  // it is joined to the one before
  EXPECT_EQ(after({3, 0}, {5, 0}, 2), (Lines{0, 5, 10}));  // lines in front of it are replaced
}

}  // namespace
}  // namespace gapcheck::app::lsp
