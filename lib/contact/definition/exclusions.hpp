#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "model/model.hpp"

namespace gapcheck::contact {

/// *CONTACT_EXCLUDE_INTERACTION for one contact: pairs of parts between which there is none.
class Exclusions {
 public:
  Exclusions(const model::Model& model, ContactId contact);
  [[nodiscard]] bool empty() const { return pairs_.empty(); }
  /// In either order; unknown parts are never excluded.
  [[nodiscard]] bool excluded(PartIndex a, PartIndex b) const;
  /// Why a definition is not supported (sides that are neither part nor part set); empty: all are.
  [[nodiscard]] const std::string& not_honoured() const { return not_honoured_; }

 private:
  std::vector<std::pair<std::vector<bool>, std::vector<bool>>> pairs_;  // masks over Model::parts
  std::string not_honoured_;
};

}  // namespace gapcheck::contact
