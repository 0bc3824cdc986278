#include "as_if.hpp"

#include <fmt/format.h>

#include <utility>

#include "audit/shared/length_unit.hpp"

namespace gapcheck::app {
namespace {

/// `--as-if thickness`: audit::recommended_millimetres without OPTT and IGNORE.
constexpr std::string_view workshop_check = "thickness";

}  // namespace

std::string check_assumption(const std::string& text) {
  if (text == workshop_check) return "";
  const auto read = model::read_assumption(text);
  return read ? "" : read.error().message;
}

Result<std::vector<model::Assumption>> assumptions(const std::vector<std::string>& texts, double millimetre) {
  std::vector<model::Assumption> list;
  for (const std::string& text : texts) {
    if (text != workshop_check) {
      auto read = model::read_assumption(text);
      if (!read) return read.error();
      list.push_back(std::move(read).value());
      continue;
    }
    if (!(millimetre > 0))
      return plain_error(
          fmt::format("--as-if {0}: {1} mm in which unit? Give --units, or --as-if "
                      "SST=…,MST=…,OPTT=0,IGNORE=0",
                      workshop_check, audit::recommended_millimetres));
    const double thickness = audit::recommended_millimetres * millimetre;
    for (const auto& [field, value] :
         {std::pair<const char*, double>{"SST", thickness}, {"MST", thickness}, {"OPTT", 0}, {"IGNORE", 0}})
      list.push_back({field, value});
  }
  return list;
}

}  // namespace gapcheck::app
