#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "audit/rule.hpp"
#include "audit/shared/worst_by_key.hpp"
#include "contact/surface/contact_surfaces.hpp"

namespace gapcheck::audit {

/// The contacts (chosen by --contact) whose thickness keeps surfaces apart. Ties are left out and counted
/// for --stats: their thickness decides only what ties.
[[nodiscard]] std::vector<ContactIndex> contacts_with_thickness(const RuleIdentity& rule, Context& context);

/// The segments of one part in one contact that a rule objects to. `worst.key` is the part.
struct PartSegments {
  ContactIndex contact;
  const contact::Segments* segments = nullptr;  ///< of the surfaces that the context keeps
  Worst worst;                                  ///< `item`: the worst segment
  [[nodiscard]] PartIndex part() const { return PartIndex{static_cast<std::uint32_t>(worst.key)}; }
};

/// Weighs the segments of one side by part and appends the parts to `list`; parts that --part does not name and
/// segments without a known part do not count. `weigh(segment)`: not above 0 for sound segments.
void weigh_by_part(std::vector<PartSegments>& list, const Context& context, ContactIndex contact,
                   const contact::Segments& segments, const std::function<double(std::size_t)>& weigh);

/// One finding per part, the worst parts of each contact in full. `words(part)` is the message of one part, `others`
/// describes the rest: "parts whose …".
void add_by_part(const RuleIdentity& rule, const Context& context, Report& report,
                 const std::vector<PartSegments>& list, const std::function<std::string(const PartSegments&)>& words,
                 const std::string& others);

/// A finding at the element of a segment of a known part.
[[nodiscard]] Finding finding_at_segment(const RuleIdentity& rule, const Context& context,
                                         const model::Contact& contact, const contact::Segments& segments,
                                         std::size_t segment, std::string message);

/// "part 7".
[[nodiscard]] std::string part_name(const model::Model& model, PartIndex part);
/// "shell 12", "element 12".
[[nodiscard]] std::string element_name(const model::Mesh& mesh, const contact::Segments& segments, std::size_t segment);
/// "element" or "elements", with the number before it.
[[nodiscard]] std::string count_elements(std::uint64_t count);

}  // namespace gapcheck::audit
