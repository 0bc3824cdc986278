#pragma once
#include <cstdint>
#include <string>

#include "base/vector.hpp"
#include "model/entity/part.hpp"

namespace gapcheck::model {

/// *DATABASE_CROSS_SECTION_PLANE and _SET (Keyword User's Manual, Vol. I), in the model's units and axes.
struct CrossSection {
  std::int64_t id = 0;  ///< CSID, or its number in the order of the deck
  bool plane = false;   ///< _PLANE; otherwise _SET
  // Of _PLANE.
  std::int64_t parts = 0;          ///< PSID; 0: all
  Vector tail = Vector::Zero();    ///< XCT, YCT, ZCT: in the plane
  Vector normal = Vector::Zero();  ///< from the tail to XCH, YCH, ZCH
  double radius = 0;               ///< RADIUS; 0: not round
  Vector edge = Vector::Zero();    ///< from the tail to XHEV, YHEV, ZHEV
  double along = 0, across = 0;    ///< LENL, LENM; 0: without end
  // Of _SET.
  std::int64_t nodes = 0, solids = 0;  ///< NSID, HSID
  std::int64_t beams = 0, shells = 0;  ///< BSID, SSID
  std::int64_t others = 0;             ///< TSID or DSID: thick shells, discrete elements
  // Of both.
  std::string title;
  std::int64_t system = 0;          ///< ID: what the section's axes or place follow; 0: they stay
  std::int64_t kind_of_system = 0;  ///< ITYPE
  Place place;
};

/// *INITIAL_STRESS_SECTION: the normal stress of the solids of a cross-section while the curve lasts.
struct SectionPreload {
  std::int64_t id = 0;       ///< ISSID
  std::int64_t section = 0;  ///< CSID
  std::int64_t curve = 0;    ///< LCID: stress over time
  std::int64_t parts = 0;    ///< PSID; 0: all
  std::int64_t vector = 0;   ///< VID: the normal; 0: that of the plane
  std::int64_t shear = 0;    ///< IZSHEAR; 0: no shear stress meanwhile, 1: shear develops
  std::int64_t ghost = 0;    ///< ISTIFF
  double scale = 1;          ///< from the file's unit of stress to the model's
  Place place;
};

}  // namespace gapcheck::model
