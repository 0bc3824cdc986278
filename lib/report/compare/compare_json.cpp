#include <nlohmann/json.hpp>

#include "report/compare/compare.hpp"

namespace gapcheck::report {
namespace {

using Json = nlohmann::ordered_json;

Json comparison_entry(const ContactComparison& c) {
  Json json{{"id", c.id}};
  if (!c.title.empty()) json["title"] = c.title;
  if (!c.type.empty()) json["type"] = c.type;
  json["agree"] = c.agree;
  json["depth_differs"] = c.depth_differs;
  json["only_first"] = c.only_first;
  json["only_second"] = c.only_second;
  json["largest_difference"] = c.largest_difference;
  if (c.missing_in_first) json["missing_in_first"] = true;
  if (c.missing_in_second) json["missing_in_second"] = true;
  if (c.not_checked) json["not_checked"] = true;
  if (c.counts_only) json["counts_only"] = true;
  if (c.by_number > 0) json["by_number"] = c.by_number;
  if (c.ties_compared) {
    json["ties"] = {{"agree", c.ties_agree},
                    {"other_reason", c.ties_other_reason},
                    {"only_first", c.ties_only_first},
                    {"only_second", c.ties_only_second}};
    if (c.ties_out_of_reach > 0) json["ties"]["out_of_reach"] = c.ties_out_of_reach;
  }
  return json;
}

Json tie_json(const TieDifference& d) {
  Json entry{{"contact", d.contact}, {"node", d.node}};
  if (d.first) entry["first"] = name(*d.first);
  if (d.second) entry["second"] = name(*d.second);
  return entry;
}

Json pair_json(const CurvePair& pair) {
  using enum CurvePair::Verdict;
  Json entry{{"name", pair.name},
             {"verdict", pair.verdict == agrees    ? "agrees"
                         : pair.verdict == differs ? "differs"
                                                   : "no_common_times"}};
  if (pair.not_numbers) entry["not_numbers"] = true;
  if (pair.verdict == no_common_times) return entry;
  entry["relative_difference"] = pair.relative_difference;
  entry["l2_difference"] = pair.l2_difference;
  entry["largest_difference"] = pair.largest_difference;
  entry["time"] = pair.time;
  entry["largest_first"] = pair.largest_first;
  entry["largest_second"] = pair.largest_second;
  if (pair.rating)
    entry["rating"] = {{"overall", pair.rating->overall()},
                       {"corridor", pair.rating->corridor},
                       {"phase", pair.rating->phase},
                       {"magnitude", pair.rating->magnitude},
                       {"slope", pair.rating->slope}};
  return entry;
}

Json curves_json(const CurveComparison& curves) {
  Json json{{"tolerance", curves.tolerance},   {"agree", curves.agree},
            {"differ", curves.differ},         {"end_first", curves.end_first},
            {"end_second", curves.end_second}, {"pairs", Json::array()},
            {"only_first", curves.only_first}, {"only_second", curves.only_second}};
  for (const CurvePair& pair : curves.pairs) json["pairs"].push_back(pair_json(pair));
  return json;
}

Json motion_json(const MotionComparison& motion) {
  Json json{{"tolerance", motion.tolerance},
            {"largest_displacement", motion.largest_displacement},
            {"differ", motion.differ},
            {"end_first", motion.end_first},
            {"end_second", motion.end_second},
            {"only_first", motion.only_first},
            {"only_second", motion.only_second},
            {"times", motion.times},
            {"parts", Json::array()}};
  for (const PartMotion& part : motion.parts) {
    Json entry{{"part", part.part},       {"nodes", part.nodes},
               {"differs", part.differs}, {"largest_distance", part.largest_distance},
               {"time", part.time},       {"node", part.node},
               {"largest", part.largest}, {"mean", part.mean}};
    if (part.not_numbers) entry["not_numbers"] = true;
    json["parts"].push_back(std::move(entry));
  }
  return json;
}

Json timesteps_json(const TimestepComparison& steps) {
  Json json{{"agree", steps.agree},           {"other_node", steps.other_node},   {"differ", steps.differ},
            {"only_first", steps.only_first}, {"only_second", steps.only_second}, {"differences", Json::array()}};
  for (const TimestepDifference& d : steps.differences)
    json["differences"].push_back({{"contact", d.contact},
                                   {"side", std::string(1, d.side)},
                                   {"first", d.first},
                                   {"second", d.second},
                                   {"node_first", d.node_first},
                                   {"node_second", d.node_second}});
  return json;
}

}  // namespace

std::string comparison_json(const Comparison& comparison, const Report& first, const Report& second,
                            const RunComparison& runs) {
  Json json{{"schema", "gapcheck-compare/1"},
            {"first", {{"source", first.source}, {"input", first.input}}},
            {"second", {{"source", second.source}, {"input", second.input}}},
            {"equal", comparison.equal() && runs.equal()},
            {"contacts", Json::array()},
            {"differences", Json::array()}};
  for (const ContactComparison& contact : comparison.contacts) json["contacts"].push_back(comparison_entry(contact));
  for (const Difference& d : comparison.differences) {
    Json entry{{"contact", d.contact}, {"node", d.node}};
    if (d.first >= 0) entry["first"] = d.first;
    if (d.second >= 0) entry["second"] = d.second;
    json["differences"].push_back(std::move(entry));
  }
  if (!comparison.tie_differences.empty()) {
    json["tie_differences"] = Json::array();
    for (const TieDifference& d : comparison.tie_differences) json["tie_differences"].push_back(tie_json(d));
  }
  const TimestepComparison& steps = comparison.timesteps;
  if (steps.agree + steps.other_node + steps.differ > 0) json["timesteps"] = timesteps_json(steps);
  if (runs.curves != nullptr) json["curves"] = curves_json(*runs.curves);
  if (runs.motion != nullptr) json["motion"] = motion_json(*runs.motion);
  return json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

}  // namespace gapcheck::report
