#include "records/penetration.hpp"

namespace gapcheck {

std::string_view name(Feature feature) {
  switch (feature) {
    case Feature::face:
      return "face";
    case Feature::edge:
      return "edge";
    case Feature::corner:
      return "corner";
  }
  return "?";
}

std::string_view name(Outcome outcome) {
  switch (outcome) {
    case Outcome::moved:
      return "moved";
    case Outcome::kept:
      return "kept";
    case Outcome::forced:
      return "forced";
    case Outcome::released:
      return "released";
    case Outcome::reported:
      return "reported";
  }
  return "?";
}

std::string_view name(ThicknessRule rule) {
  switch (rule) {
    case ThicknessRule::none:
      return "none";
    case ThicknessRule::element:
      return "element";
    case ThicknessRule::edge_limit:
      return "edge-limit";
    case ThicknessRule::contact_card:
      return "contact-card";
    case ThicknessRule::global:
      return "global";
    case ThicknessRule::part_contact:
      return "part-contact";
    case ThicknessRule::solid_coating:
      return "solid-coating";
    case ThicknessRule::beam_section:
      return "beam-section";
  }
  return "?";
}

}  // namespace gapcheck
