#include "report/format/fix_proof_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "report/format/fix_words.hpp"
#include "report/item/describe.hpp"
#include "report/write/table.hpp"

namespace gapcheck::report {
namespace {

using Json = nlohmann::ordered_json;
using fix_words::number;

/// Energy that is only the rounding of the other energies is none.
std::string supplied_energy(const RunTrial& trial) {
  const double rounding = 1e-12 * std::max(trial.largest_kinetic, -trial.least_sliding);
  return number(std::abs(trial.supplied) <= rounding ? 0 : trial.supplied);
}

/// Something that is compared before and after.
struct ProofQuantity {
  const char* label;
  bool of_run;  ///< only known if the deck was run
  std::string (*text)(const RunTrial& trial);
};

using Trial = RunTrial;
constexpr std::array<ProofQuantity, 14> proof_quantities{{
    {"nodes moved by contacts at the start", false, [](const Trial& t) { return std::to_string(t.start.moved); }},
    {"nodes pushed at the start", false, [](const Trial& t) { return std::to_string(t.forced_at_start()); }},
    {"nodes released at the start", false, [](const Trial& t) { return std::to_string(t.released_at_start()); }},
    {"energy from nothing", false, [](const Trial& t) { return number(t.start.energy); }},
    {"largest contact force on a node at time 0", true, [](const Trial& t) { return number(t.largest_force); }},
    {"first step", false, [](const Trial& t) { return t.start.first_step ? number(*t.start.first_step) : "-"; }},
    {"time reached", true, [](const Trial& t) { return number(t.time); }},
    {"cycles", true, [](const Trial& t) { return std::to_string(t.cycles); }},
    {"nodes moved by contacts during the run", true, [](const Trial& t) { return std::to_string(t.shot); }},
    {"nodes released at the end", true, [](const Trial& t) { return std::to_string(t.released); }},
    {"energy supplied by motion and loads", true, supplied_energy},
    {"largest kinetic energy", true, [](const Trial& t) { return number(t.largest_kinetic); }},
    {"smallest sliding energy", true, [](const Trial& t) { return number(t.least_sliding); }},
    {"energy created by elements and contacts", true, [](const Trial& t) { return number(t.created); }},
}};

/// Why a run could not be made or ended.
void run_ends(const RunTrial& trial, std::string_view which, std::string& out) {
  for (const StartRefusal& why : trial.start.refused) {
    const std::string place = why.file.empty() ? "" : fmt::format("{}:{}: ", printable_path(why.file), why.line);
    const std::string keyword = why.keyword.empty() ? "" : fmt::format("*{}: ", printable(why.keyword));
    out += fmt::format("  {} {}: {}{}{}\n", which, trial.ran ? "is run without" : "cannot be run", place, keyword,
                       printable(why.why));
  }
  if (trial.ran) out += fmt::format("  {} ended by: {}\n", which, printable(trial.end));
}

Json trial_json(const RunTrial& trial) {
  Json json{{"moved_at_start", trial.start.moved},
            {"forced_at_start", trial.forced_at_start()},
            {"released_at_start", trial.released_at_start()},
            {"start_energy", trial.start.energy},
            {"ran", trial.ran}};
  if (trial.start.first_step) json["first_step"] = *trial.start.first_step;
  json["refused"] = Json::array();
  for (const StartRefusal& why : trial.start.refused) {
    json["refused"].push_back({{"message", why.why}});
    if (!why.keyword.empty()) json["refused"].back()["keyword"] = why.keyword;
    if (!why.file.empty()) json["refused"].back().update({{"file", why.file}, {"line", why.line}});
  }
  if (!trial.ran) return json;
  json["largest_force"] = trial.largest_force;
  json["end"] = trial.end;
  json["failed"] = trial.failed;
  json["time"] = trial.time;
  json["cycles"] = trial.cycles;
  json["energy"] = {{"supplied", trial.supplied},
                    {"largest_kinetic", trial.largest_kinetic},
                    {"least_sliding", trial.least_sliding},
                    {"created", trial.created}};
  json["moved_during_run"] = trial.shot;
  json["released_at_end"] = trial.released;
  return json;
}

}  // namespace

void append_proof(const FixProof& proof, std::string& out) {
  // Rows without anything are left out.
  std::vector<Row<3>> rows;
  for (const ProofQuantity& quantity : proof_quantities) {
    const auto text = [&](const RunTrial& trial) { return quantity.of_run && !trial.ran ? "-" : quantity.text(trial); };
    Row<3> row{quantity.label, text(proof.before), text(proof.after)};
    if (row[1] != "0" || row[2] != "0") rows.push_back(std::move(row));
  }
  out += "\nRun of the deck before and after the correction\n";
  constexpr std::array<Column, 3> columns{{{"", Align::left}, {"before"}, {"after"}}};
  append_table(
      columns, rows.size(), [&](std::size_t i, Row<3>& row) { row = rows[i]; }, "  ", out);
  run_ends(proof.before, "the deck", out);
  run_ends(proof.after, "the corrected deck", out);
}

std::string_view verdict(const FixProof& proof) {
  return proof.holds()     ? "; proven by a run"
         : proof.after.ran ? "; not proven: a run does not start clean, or fails"
                           : "; not proven: it cannot be run";
}

nlohmann::ordered_json proof_json(const FixProof& proof) {
  return {{"holds", proof.holds()}, {"before", trial_json(proof.before)}, {"after", trial_json(proof.after)}};
}

}  // namespace gapcheck::report
