#pragma once
#include "contact/pair/penetration_list.hpp"
#include "contact/present_surfaces.hpp"

namespace gapcheck::contact {

class Exclusions;

/// Shared by the search for the penetrations of all contacts. All references must outlive it.
struct InitialSearch {
  const model::Model& model;
  const InitialOptions& options;
  const CandidateSearch& search;
  const TiedPairs& ties;  ///< of the contacts before
  PresentSurfaces& present;
  InitialCounters& counters;
};

/// True if each side's nodes are searched in the other side's segments: two-way types, and those that judge segments.
[[nodiscard]] bool searches_both_sides(const ContactType& type);

/// Adds the penetrations of one contact, deepest first, and moves the nodes that the solver moves: side A's nodes
/// before side B's are searched. `surfaces`: of this contact on the present coordinates. `moved_into`: gets the
/// moved nodes that land in other segments, if the options ask for them.
void find_penetrations(const InitialSearch& scene, ContactIndex contact, const ContactSurfaces& surfaces,
                       const Exclusions& exclusions, PenetrationList& list, std::vector<MovedInto>& moved_into);

}  // namespace gapcheck::contact
