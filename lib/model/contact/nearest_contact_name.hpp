#pragma once
#include <string>
#include <string_view>

namespace gapcheck::model {

/// The known contact that a misspelt name comes nearest to, "CONTACT_AUTOMATIC_SINGLE_SURFACE", without option words.
/// Names are compared letter by letter (four letters weigh one word) and word by word, also regardless of the words'
/// order. Empty where none comes near, and for names of more than 100 characters.
[[nodiscard]] std::string nearest_contact_name(std::string_view written);

}  // namespace gapcheck::model
