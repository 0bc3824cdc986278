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

bool within_rounding(const Penetration& record) {
  constexpr double share_of_distance = 1e-6, single_precision = 0x1p-23;
  return record.depth <= share_of_distance * record.contact_distance ||
         record.depth <= single_precision * record.original.cwiseAbs().maxCoeff();
}

}  // namespace gapcheck
