#pragma once
#include <string>
#include <string_view>

namespace gapcheck::model {

/// The known contact nearest to a misspelt name, "CONTACT_AUTOMATIC_SINGLE_SURFACE", without option words. Names are
/// compared letter by letter (four letters weigh one word) and word by word, also in any order of words. Empty if none
/// is near, and for names of more than 100 characters.
[[nodiscard]] std::string nearest_contact_name(std::string_view written);

}  // namespace gapcheck::model
