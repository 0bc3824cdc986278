#include "audit/unread_fields.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "audit/rules.hpp"

namespace gapcheck::audit {
namespace {

/// Lines, both included.
using LineRange = std::pair<std::uint32_t, std::uint32_t>;
using Ranges = std::map<std::string, std::vector<LineRange>, std::less<>>;  ///< by path; disjoint, ascending

bool holds(const Ranges& ranges, std::string_view path, std::uint32_t line) {
  const auto found = ranges.find(path);
  if (found == ranges.end()) return false;
  const auto behind = std::upper_bound(found->second.begin(), found->second.end(), line,
                                       [](std::uint32_t l, const LineRange& range) { return l < range.first; });
  return behind != found->second.begin() && line <= std::prev(behind)->second;
}

/// Blocks with so many independent rows that one unread field says nothing about the others.
bool has_independent_rows(std::string_view name) {
  return name == "NODE" || name.starts_with("ELEMENT_") || name.starts_with("SET_");
}

bool judges_thickness(std::string_view id) {
  const std::array rules{&rule::penetration_free_at::definition, &rule::solid_early_release::definition,
                         &rule::thickness_conflict::definition,  &rule::thickness_exceeds_mesh::definition,
                         &rule::thickness_ignored::definition,   &rule::thickness_limited::definition,
                         &rule::thickness_override::definition,  &rule::thickness_too_thin::definition};
  return std::any_of(rules.begin(), rules.end(), [&](const Rule* rule) { return rule->identity.id == id; });
}

/// What the errors of reading have left without a value.
class UnreadFields {
 public:
  UnreadFields(const keyword::Deck& deck, const model::Model& model, const Diagnostics& diagnostics)
      : deck_(deck), model_(model) {
    for (const auto& [path, line] : diagnostics.error_lines())
      if (line > 0) lines_[path].push_back(line);
    if (lines_.empty()) return;
    const std::span<const keyword::Block> blocks = deck.blocks();
    std::map<std::uint32_t, std::size_t> open;  // by file: its last block so far
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      const std::uint32_t file = blocks[i].file.value;
      if (const auto before = open.find(file); before != open.end()) add(blocks[before->second], blocks[i].line - 1);
      open[file] = i;
    }
    for (const auto& [file, last] : open) add(blocks[last], std::numeric_limits<std::uint32_t>::max());
    for (Ranges* ranges : {&own_, &whole_})
      for (auto& [path, list] : *ranges) std::sort(list.begin(), list.end());
  }

  [[nodiscard]] bool any() const { return !own_.empty(); }
  [[nodiscard]] bool explains(const Finding& f) const {
    if (f.line > 0 && holds(own_, f.file, f.line)) return true;
    if (judges_thickness(f.id) && (unread_part(f.part) || unread_part(f.element_part))) return true;
    // A contact's time step takes masses of nodes, to which the parts around add theirs.
    if (f.id == rule::contact_timestep::definition.identity.id && any_unread_part()) return true;
    return f.id == rule::empty_surface::definition.identity.id && unread_sets(f);
  }

 private:
  void add(const keyword::Block& block, std::uint32_t last) {
    const std::string& path = deck_.file(block.file).path;
    const auto found = lines_.find(path);
    if (found == lines_.end() || block.name.starts_with("INCLUDE")) return;  // its errors are about files
    const std::vector<std::uint32_t>& lines = found->second;
    auto line = std::upper_bound(lines.begin(), lines.end(), block.line);  // the keyword's own line is no field
    if (line == lines.end() || *line > last) return;
    whole_[path].emplace_back(block.line, last);
    if (!has_independent_rows(block.name)) {
      own_[path].emplace_back(block.line, last);
      return;
    }
    for (; line != lines.end() && *line <= last; ++line) own_[path].emplace_back(*line, *line);
  }

  [[nodiscard]] bool unread(const Ranges& ranges, model::Place place) const {
    return place.file != none<FileIndex> && holds(ranges, deck_.file(place.file).path, place.line);
  }

  [[nodiscard]] bool unread_part(std::int64_t id) const {
    const auto found = model_.part_of_id.find(id);
    if (id == 0 || found == model_.part_of_id.end()) return false;
    const model::Part& part = model_.part(found->second);
    return unread(own_, part.place) || (part.section && unread(own_, model_.sections[*part.section].place));
  }

  [[nodiscard]] bool any_unread_part() const {
    return std::any_of(model_.parts.begin(), model_.parts.end(),
                       [&](const model::Part& part) { return unread_part(part.id.value); });
  }

  template <class Sets>
  [[nodiscard]] bool unread_set(const Sets& sets, std::int64_t id) const {
    const auto found = sets.find(id);
    return found != sets.end() && unread(whole_, found->second.place);
  }

  /// Whether a side of the finding's contact is a set with an unread field.
  [[nodiscard]] bool unread_sets(const Finding& f) const {
    for (const model::Contact& contact : model_.contacts) {
      if (contact.id.value != f.contact) continue;
      for (const model::SurfaceInput* side : {&contact.a, &contact.b}) {
        const auto type = static_cast<model::SurfaceType>(side->type);
        using enum model::SurfaceType;
        if ((type == segment_set && unread_set(model_.sets.segments, side->id)) ||
            (type == shell_set && unread_set(model_.sets.shells, side->id)) ||
            (type == node_set && unread_set(model_.sets.nodes, side->id)) ||
            ((type == part_set || type == exempted_part_set) && unread_set(model_.sets.parts, side->id)) ||
            (type == branch && unread_set(model_.sets.branches, side->id)))
          return true;
      }
    }
    return false;
  }

  const keyword::Deck& deck_;
  const model::Model& model_;
  std::map<std::string, std::vector<std::uint32_t>, std::less<>> lines_;  ///< of errors, by path, ascending
  Ranges own_;                                                            ///< lines about which nothing more is said
  Ranges whole_;                                                          ///< all lines of the blocks with them
};

}  // namespace

std::size_t leave_out_follow_ups(const keyword::Deck& deck, const model::Model& model, const Diagnostics& diagnostics,
                                 Report& report) {
  const UnreadFields unread(deck, model, diagnostics);
  if (!unread.any()) return 0;
  return std::erase_if(report.findings, [&](const Finding& f) { return unread.explains(f); });
}

}  // namespace gapcheck::audit
