#include "records/report.hpp"

#include <algorithm>

namespace gapcheck {

void InitialSummary::add(const InitialSummary& other) {
  const bool replaces = messages + nodes + eliminated == 0 || (nodes == 0 && other.nodes > 0);
  if (replaces) {
    least = other.least;
    greatest = other.greatest;
  } else if (nodes == 0 || other.nodes > 0) {
    least = std::min(least, other.least);
    greatest = std::max(greatest, other.greatest);
  }
  messages += other.messages;
  nodes += other.nodes;
  eliminated += other.eliminated;
}

void count(const Penetration& record, ContactSummary& contact) {
  switch (record.kind) {
    case PenetrationKind::initial:
      ++contact.penetrations;
      contact.max_penetration = std::max(contact.max_penetration, record.depth);
      break;
    case PenetrationKind::released:
      ++contact.released;
      break;
    case PenetrationKind::edge_zone:
      ++contact.edge_zone;
      break;
    case PenetrationKind::segment:
      ++contact.segment_penetrations;
      break;
    case PenetrationKind::mortar:
      ++contact.mortar_penetrations;
      break;
    case PenetrationKind::edge:
      ++contact.edge_penetrations;
      break;
  }
}

void clear_counts(ContactSummary& contact) {
  contact.penetrations = contact.released = contact.edge_zone = 0;
  contact.segment_penetrations = contact.mortar_penetrations = contact.edge_penetrations = 0;
  contact.max_penetration = 0;
}

}  // namespace gapcheck
