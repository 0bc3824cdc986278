#include "records/penetration.hpp"

namespace gapcheck {

std::string_view rule_id(PenetrationKind kind) {
  switch (kind) {
    case PenetrationKind::initial: return "GC101";
    case PenetrationKind::released: return "GC102";
    case PenetrationKind::edge_zone: return "GC106";
    case PenetrationKind::segment: return "GC107";
    case PenetrationKind::mortar: return "GC108";
    case PenetrationKind::edge: return "GC109";
  }
  return "?";
}

std::string_view name(Feature feature) {
  switch (feature) {
    case Feature::face: return "face";
    case Feature::edge: return "edge";
    case Feature::corner: return "corner";
  }
  return "?";
}

std::string_view name(Outcome outcome) {
  switch (outcome) {
    case Outcome::moved: return "moved";
    case Outcome::kept: return "kept";
    case Outcome::forced: return "forced";
    case Outcome::released: return "released";
    case Outcome::reported: return "reported";
  }
  return "?";
}

std::string_view name(ThicknessRule rule) {
  switch (rule) {
    case ThicknessRule::none: return "none";
    case ThicknessRule::element: return "element";
    case ThicknessRule::edge_limit: return "edge-limit";
    case ThicknessRule::contact_card: return "contact-card";
    case ThicknessRule::global: return "global";
    case ThicknessRule::part_contact: return "part-contact";
    case ThicknessRule::solid_coating: return "solid-coating";
    case ThicknessRule::beam_section: return "beam-section";
  }
  return "?";
}

}  // namespace gapcheck
