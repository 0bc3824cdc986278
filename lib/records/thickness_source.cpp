#include "records/thickness_source.hpp"

namespace gapcheck {

std::string_view thickness_source(ThicknessRule rule) {
  switch (rule) {
    case ThicknessRule::none:
      return "no thickness";
    case ThicknessRule::element:
      return "element thickness";
    case ThicknessRule::edge_limit:
      return "0.4 edge limit";
    case ThicknessRule::contact_card:
      return "SST/MST";
    case ThicknessRule::global:
      return "TH of *CONTROL_CONTACT";
    case ThicknessRule::part_contact:
      return "OPTT of *PART_CONTACT";
    case ThicknessRule::solid_coating:
      return "SLDTHK";
    case ThicknessRule::beam_section:
      return "beam section";
  }
  return "no thickness";
}

}  // namespace gapcheck
