#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace gapcheck::model {

/// The cards that stand behind the three mandatory ones, by type of contact.
enum class ExtraCards : unsigned char {
  none,
  one,               ///< ERODING, INTERFERENCE, CONSTRAINT, RIGID, TIEBREAK_NODES, COMPOSITE, …
  tiebreak,          ///< OPTION card, two more for the options with a cohesive law
  tiebreak_damping,  ///< the same with a damping card behind the first
  tiebreak_user,     ///< three
  tied_weld,         ///< one, and the parameters that it counts
  drawbead,          ///< one, and one per bead
  drawbead_initialize,
  own,  ///< none of the cards of a 3D contact
};

/// The words of a keyword's name, which underscores keep apart; views into the name.
[[nodiscard]] std::vector<std::string_view> words_of(std::string_view name);

/// What the name of a *CONTACT keyword says.
struct ContactName {
  std::string bare;  ///< without option words, MORTAR last: "CONTACT_AUTOMATIC_SINGLE_SURFACE_MORTAR"
  bool known = false;
  bool modifier = false;    ///< no interface of its own
  bool transducer = false;  ///< only the first card counts
  ExtraCards extra = ExtraCards::none;
  bool id = false, mpp = false, thermal = false, thermal_friction = false, ortho_friction = false;
};

/// Takes the option words out of a name (upper case, without `*`), wherever they stand: ID, TITLE, MPP, THERMAL,
/// THERMAL_FRICTION, ORTHO_FRICTION, SMOOTH.
[[nodiscard]] ContactName parse_contact_name(std::string_view written);

/// All contacts that are known, behind CONTACT_ and without option words and MORTAR.
[[nodiscard]] const std::vector<std::string_view>& known_contact_names();

}  // namespace gapcheck::model
