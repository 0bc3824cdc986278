#include "lsp/repair_job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <utility>

#include "audit/repair/deck_edits.hpp"
#include "audit/repair/repair_plan.hpp"
#include "lsp/uri.hpp"

namespace gapcheck::app::lsp {

Result<DeckRepairs> repairs_for_editor(const std::string& deck, const OptionsOf& options_of) try {
  Diagnostics diagnostics;
  const auto input = keyword::read_deck(deck, options_of(deck).audit.read, diagnostics);
  if (!input) return input.error();
  auto plan = audit::list_written_repairs(input.value(), diagnostics);
  if (!plan) return plan.error();
  DeckRepairs repairs;
  repairs.plan = std::move(plan).value();
  audit::take_line_ends(input.value(), repairs.plan);
  for (const keyword::SourceFile& file : input.value().files()) {
    const auto now = FileBytes::begin(file.path);
    if (!now) return now.error();
    repairs.files.emplace(file.path, ReadFile{canonical(file.path), now.value().stamp()});
  }
  // Then the stamps are those of what was read.
  if (Status status = input.value().unchanged(); !status.ok()) return status.error();
  std::size_t written = 0;
  for (const RepairPair& pair : repairs.plan.pairs)
    written += static_cast<std::size_t>(
        std::ranges::count_if(pair.repairs, [](const Repair& repair) { return !repair.lines.empty(); }));
  repairs.summary = fmt::format("{}: {} repairs of cards", deck, written);
  return repairs;
} catch (const std::exception& error) {  // too little memory
  return Diagnostic{Severity::error, deck, 0, error.what()};
}

}  // namespace gapcheck::app::lsp
