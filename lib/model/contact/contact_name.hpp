#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "model/contact/contact_kind.hpp"

namespace gapcheck::model {

/// The words of a keyword's name, separated by underscores; views into the name.
[[nodiscard]] std::vector<std::string_view> words_of(std::string_view name);

/// Option words of a *CONTACT keyword: they may be anywhere in it.
struct ContactOptions {
  bool id = false;  ///< ID or TITLE
  bool mpp = false, mortar = false, smooth = false;
  bool thermal = false;  ///< THERMAL or THERMAL_FRICTION
  bool thermal_friction = false, ortho_friction = false;
  bool operator==(const ContactOptions&) const = default;
};

/// What the name of a *CONTACT keyword says.
struct ContactName {
  std::string bare;                   ///< without option words, MORTAR last: "CONTACT_AUTOMATIC_SINGLE_SURFACE_MORTAR"
  const ContactKind* kind = nullptr;  ///< the row of the table; nullptr: unknown, or a layout of its own
  bool own_layout = false;            ///< 2D, ENTITY, INTERIOR, …: no card of a 3D contact
  bool modifier = false;              ///< of these: not an interface of its own
  ContactOptions options;
  [[nodiscard]] bool known() const { return kind != nullptr || own_layout; }
};

/// Removes the option words from a name (upper case, without `*`), wherever they are: ID, TITLE, MPP, MORTAR, THERMAL,
/// THERMAL_FRICTION, ORTHO_FRICTION, SMOOTH. What is left must be a kind of the table, word by word; MORTAR goes with
/// automatic and forming kinds only.
[[nodiscard]] ContactName parse_contact_name(std::string_view written);

/// All known contacts in the order of their names, without CONTACT_, option words and MORTAR; then the keywords with a
/// layout of their own.
[[nodiscard]] const std::vector<std::string_view>& known_contact_names();

}  // namespace gapcheck::model
