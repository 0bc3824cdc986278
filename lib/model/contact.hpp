#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/ids.hpp"
#include "model/part.hpp"

namespace gapcheck::model {

/// What one side of a contact is given by.
enum class SurfaceType : std::uint8_t {
  segment_set = 0,
  shell_set = 1,
  part_set = 2,
  part = 3,
  node_set = 4,
  all = 5,
  exempted_part_set = 6,
  branch = 7,
};

struct SurfaceInput {
  std::int64_t id = 0;    ///< set or part; 0 with type part_set or part on side A means all
  std::int64_t type = 0;  ///< as written; see SurfaceType
  std::int64_t box = 0;   ///< *DEFINE_BOX; 0 = none
  bool given = false;     ///< false: both id and type are blank
};

/// One 3D *CONTACT definition with all its cards. Defaults are the solver's; where "not given" matters, it is an
/// optional. Old and new field names as in contact_rules: A = slave = tracked, B = master = reference.
struct Contact {
  ContactId id;
  /// Place in the deck among all contacts, from 1; 0 for what only modifies others (CONTACT_INTERIOR, AUTO_MOVE,
  /// ADD_WEAR), which then has id 0 too unless one is given.
  std::uint32_t order = 0;
  bool default_id = false;  ///< no ID in the deck: the id is the order, or a free number where that is taken
  std::string title;
  std::string keyword;      ///< without option suffixes: "CONTACT_AUTOMATIC_SINGLE_SURFACE"
  std::string written;      ///< as in the deck, upper case, without `*`
  bool known = true;        ///< false: no such keyword is known; only id, title and place are filled
  bool own_layout = false;  ///< 2D, ENTITY, INTERIOR, …: the cards are not those of a 3D contact and were not read
  Place place;

  SurfaceInput a, b;
  // Card 2
  double fs = 0, fd = 0, dc = 0, vc = 0, vdc = 0;
  std::int64_t penchk = 0;
  double birth = 0, death = 1e20;
  // Card 3; sst, mst: zero = not given
  double sfs = 1, sfm = 1, sst = 0, mst = 0, sfst = 1, sfmt = 1, fsf = 1, vsf = 1;
  // Card 4 of tiebreak types: OPTION
  std::int64_t tiebreak_option = 0;
  // MPP card
  std::optional<std::int64_t> mpp_ignore;
  double parmax = 0;  ///< 0 = not given
  // A
  std::int64_t soft = 0;
  double sofscl = 0.1;
  std::int64_t lcidab = 0;
  double maxpar = 0;  ///< 0 = not given
  std::int64_t sbopt = 2, depth = 2, bsort = 0;
  // B
  double penmax = 0;
  std::int64_t thkopt = 0, shlthk = 0, snlog = 0, isym = 0;
  double sldthk = 0, sldstf = 0;
  // C
  std::int64_t igap = 1;
  std::optional<std::int64_t> ignore;
  double dprfac = 0, dtstif = 0;
  // D
  double dtpchk = 0;
  std::int64_t tcso = 0, tiedid = 0, shledg = 0;
  // E
  std::int64_t sharec = 0, ipback = 0, srnde = 0;
  // F, G
  double shloff = 0;
  std::uint32_t optional_cards = 0;  ///< how many of A … G are in the deck
};

/// *CONTACT_EXCLUDE_INTERACTION: no contact between the two sides, in one contact (0 = in all).
struct ContactExclusion {
  std::int64_t contact = 0;
  struct Pair {
    std::int64_t a = 0, b = 0;  ///< set or part ids
    std::int64_t type_a = 0, type_b = 0;
  };
  std::vector<Pair> pairs;
  Place place;
};

/// The solver-wide settings that contact needs, with the solver's defaults.
struct Controls {
  // *CONTROL_CONTACT card 1
  double slsfac = 0.1;
  double rwpnal = 0;  ///< 0: rigid walls do not see the nodes of rigid bodies
  std::int64_t shlthk = 0, penopt = 1, orien = 1;
  // card 2
  double xpene = 4;
  std::int64_t ssthk = 0, ecdt = 0, tiedprj = 0;
  // card 3; zero = not given
  double th = 0, th_sf = 0;
  // card 4
  std::int64_t ignore = 0;
  // card 6
  std::int64_t shledg = 0, ftall = 0;
  // *CONTROL_SHELL
  std::int64_t cntco = 0, istupd = 0;
  // *CONTROL_TIMESTEP
  double tssfac = 0.9;
  std::int64_t isdo = 0;
  double dt2ms = 0;  ///< mass scaling; zero = none
  bool contact_given = false, shell_given = false;
  Place contact_place, shell_place;
};

}  // namespace gapcheck::model
