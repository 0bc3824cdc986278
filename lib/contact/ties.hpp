#pragma once
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "contact/contact_type.hpp"
#include "contact/search.hpp"
#include "contact/surface.hpp"
#include "geometry/decide.hpp"

namespace gapcheck::contact {

/// Distance within which a node ties to a segment (contact rules, section 9): shells max(0.6 (ts + tm), 0.05 of the
/// shorter diagonal), solids the latter; with negative SST or MST 0.6 (|SST| + |MST|) alone.
[[nodiscard]] double tie_distance(double node_thickness, double segment_thickness, double min_diagonal,
                                  bool solid_segment, bool negative_thickness);

/// Which nodes are tied to which parts by the tied contacts seen so far.
class Ties {
 public:
  void add(NodeIndex node, PartIndex part);
  [[nodiscard]] bool tied(NodeIndex node, PartIndex part) const;
  [[nodiscard]] bool tied(NodeIndex node) const { return parts_.contains(node.value); }
  [[nodiscard]] std::size_t size() const { return parts_.size(); }

 private:
  std::unordered_map<std::uint32_t, std::vector<PartIndex>> parts_;
};

/// Ties the nodes of one tied contact that lie within the tie distance of a segment, to the closest one; a node that an
/// earlier contact has tied stays with it. Constraint types without offset (2, 6, 7) also move the node onto the segment.
/// Returns the number of nodes tied.
std::uint64_t apply_ties(const model::Model& model, const model::Contact& contact, const ContactType& type,
                         const CandidateSearch& search, std::vector<Vector>& x, Ties& ties);

}  // namespace gapcheck::contact
