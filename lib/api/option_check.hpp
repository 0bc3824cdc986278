#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "records/report.hpp"

namespace gapcheck::api {

/// Looks at the options of a call and keeps the first fault: what would be left out in silence otherwise.
class OptionCheck {
 public:
  /// A finite number of 0 or more, or none.
  void amount(std::string_view option, std::optional<double> value);
  /// Each entry picks at least one rule on runs, or on decks.
  void rules(std::string_view option, const std::vector<std::string>& patterns, bool of_runs);
  /// Each id is that of a contact. `why`: what is said of one that is not, "the deck has no such contact".
  void contacts(const std::vector<std::int64_t>& ids, const std::vector<const gapcheck::Report*>& reports,
                std::string_view why);
  /// Each id is that of a part; `unknown`: those that are not.
  void parts(const std::vector<std::int64_t>& unknown);
  void fault(std::string message);
  /// Empty: no fault.
  [[nodiscard]] const std::string& message() const { return message_; }

 private:
  std::string message_;
};

}  // namespace gapcheck::api
