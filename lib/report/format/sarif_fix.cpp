#include "report/format/sarif_fix.hpp"

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "report/format/repair_words.hpp"
#include "report/write/percent_encoding.hpp"

namespace gapcheck::report {

nlohmann::ordered_json sarif_fix(const Repair& repair) {
  using Json = nlohmann::ordered_json;
  std::map<std::string, Json> files;
  for (const RepairLine& line : repair.lines)
    files.try_emplace(line.file, Json::array())
        .first->second.push_back(
            {{"deletedRegion", {{"startLine", line.line}}}, {"insertedContent", {{"text", line.after}}}});
  Json fix{{"description", {{"text", repair.id + ": " + what_it_does(repair)}}}, {"artifactChanges", Json::array()}};
  for (auto& [file, replacements] : files) {
    Json change{{"artifactLocation", {{"uri", file_uri(file)}}}};
    change["replacements"] = std::move(replacements);
    fix["artifactChanges"].push_back(std::move(change));
  }
  return fix;
}

}  // namespace gapcheck::report
