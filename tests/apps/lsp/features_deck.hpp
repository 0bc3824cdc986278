#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "folder_test.hpp"
#include "lsp/audit_job.hpp"
#include "lsp/features/features.hpp"
#include "lsp/uri.hpp"
#include "lsp/workspace.hpp"

namespace gapcheck::app::lsp {

inline constexpr const char* main_text =
    "*KEYWORD\n"                                  // 0
    "*PARAMETER\n"                                // 1
    "R        t       0.5I      pid         2\n"  // 2
    "*INCLUDE\n"                                  // 3
    "parts.k\n"                                   // 4
    "*SET_PART_LIST_TITLE\n"                      // 5
    "all plates\n"                                // 6
    "         7\n"                                // 7
    "         1      &pid\n"                      // 8
    "*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n"      // 9
    "         3plates against plates\n"           // 10
    "         7         0         2\n"            // 11
    "        &t\n"                                // 12
    "                              &t+2*&t\n"     // 13
    "*DEFINE_CURVE\n"                             // 14
    "        11\n"                                // 15
    "0.,0.\n"                                     // 16
    "*END\n";                                     // 17
inline constexpr const char* parts_text =
    "*PART\n"                                                      // 0
    "lower plate\n"                                                // 1
    "         1         4         5\n"                             // 2
    "upper plate\n"                                                // 3
    "         2         4         5\n"                             // 4
    "*SECTION_SHELL\n"                                             // 5
    "         4         2\n"                                       // 6
    "1.0,1.0,1.0,1.0\n"                                            // 7
    "*MAT_ELASTIC_TITLE\n"                                         // 8
    "steel\n"                                                      // 9
    "         5   7.8E-6     210.0       0.3\n"                    // 10
    "*ELEMENT_SHELL\n"                                             // 11
    "       1       1       1       2       3       4\n"           // 12
    "       2       2       1       2       3       4\n"           // 13
    "*NODE\n"                                                      // 14
    "       1             0.0             0.0             0.0\n";  // 15

/// A deck of two files, as a workspace has it.
class LspFeatures : public FolderTest {
 protected:
  void SetUp() override {
    FolderTest::SetUp();
    write("main.k", main_text);
    write("parts.k", parts_text);
    main_ = &workspace_.open(uri("main.k"), 1, main_text);
    parts_ = &workspace_.open(uri("parts.k"), 1, parts_text);
    const auto deck = deck_for_editor(path("main.k"), {}, {});
    ASSERT_NE(deck, nullptr);
    workspace_.set_deck(path("main.k"), deck);
  }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  [[nodiscard]] std::string path(const std::string& name) const { return canonical((folder_ / name).string()); }
  [[nodiscard]] std::string uri(const std::string& name) const { return uri_of(path(name)); }
  template <class Ask>
  auto ask(const Document& document, const Ask& ask) {
    const DeckFiles files = workspace_.files(document);
    return ask(Question{files, Encoding::utf16});
  }
  std::string hovered(const Document& document, Place place) {
    const json said = ask(document, [&](const Question& q) { return hover(q, place); });
    return said.is_null() ? "" : said["contents"]["value"].get<std::string>();
  }
  std::vector<std::string> completed(const std::string& line) {
    Document& document = workspace_.open(uri("new.k"), 1, line);
    const auto at = static_cast<std::uint32_t>(line.size());
    const json said = ask(document, [&](const Question& q) { return completion(q, {0, at}); });
    std::vector<std::string> labels;
    if (!said.is_null())
      for (const json& item : said["items"]) labels.push_back(item["label"]);
    return labels;
  }
  /// "main.k:8:19-23" of a location.
  [[nodiscard]] std::string place(const json& location) const {
    if (location.is_null()) return "";
    const json& range = location["range"];
    return std::filesystem::path(path_of(location["uri"].get<std::string>())).filename().string() + ":" +
           range["start"]["line"].dump() + ":" + range["start"]["character"].dump() + "-" +
           range["end"]["character"].dump();
  }
  std::string defined(const Document& document, Place at) {
    return place(ask(document, [&](const Question& q) { return definition(q, at); }));
  }
  std::vector<std::string> referenced(const Document& document, Place at) {
    std::vector<std::string> places;
    for (const json& each : ask(document, [&](const Question& q) { return references(q, at, true); }))
      places.push_back(place(each));
    std::sort(places.begin(), places.end());
    return places;
  }
  Workspace workspace_;
  Document *main_ = nullptr, *parts_ = nullptr;
};

}  // namespace gapcheck::app::lsp
