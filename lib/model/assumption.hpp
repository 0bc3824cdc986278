#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "model/model.hpp"

namespace gapcheck::model {

/// What a field would be instead of what the deck says: "SST=0.5".
struct Assumption {
  std::string field;  ///< as the manual writes it, upper case
  double value = 0;   ///< lengths in deck units
};

/// The fields that can be assumed, in the order of the cards.
[[nodiscard]] std::vector<std::string_view> assumable_fields();

/// Reads "FIELD=VALUE"; the case of the field does not matter. Error: no such field, not a number, not a whole number
/// for a field that needs one, or a value that the field cannot have.
[[nodiscard]] Result<Assumption> read_assumption(std::string_view text);

/// Changes a model as if its deck had these values: fields of contacts in all contacts, OPTT and SFT in all parts.
/// IGNORE is set wherever it can be given. Contacts that tie keep their thickness (SST, MST): there it is a tie
/// distance. A later assumption on the same field replaces an earlier one.
void assume(std::span<const Assumption> assumptions, Model& model);

}  // namespace gapcheck::model
