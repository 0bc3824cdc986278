#pragma once
#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace gapcheck::audit {

/// A limit of a rule that a settings file may replace.
struct Threshold {
  std::string_view name;     ///< "angle"
  double value;              ///< unless a settings file says otherwise
  double least, most;        ///< of what a settings file may say
  std::string_view meaning;  ///< with its unit: "degrees between the two triangles of a quad"
};

/// Values that replace those of the rules, by rule id and name: "GC504.angle".
using Thresholds = std::map<std::string, double, std::less<>>;

}  // namespace gapcheck::audit
