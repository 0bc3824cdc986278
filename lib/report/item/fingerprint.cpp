#include "report/item/fingerprint.hpp"

#include <algorithm>
#include <cmath>

#include "report/item/describe.hpp"
#include "report/item/describe_tie.hpp"

namespace gapcheck::report {
namespace {

/// FNV-1a, 64 bits, fed byte by byte in a fixed order.
class Hash {
 public:
  void byte(unsigned char value) { state_ = (state_ ^ value) * 0x100000001b3ULL; }
  void text(std::string_view text) {
    for (const char c : text) byte(static_cast<unsigned char>(c));
    byte(0);
  }
  void integer(std::int64_t value) {
    auto bits = static_cast<std::uint64_t>(value);
    for (int i = 0; i < 8; ++i, bits >>= 8) byte(static_cast<unsigned char>(bits & 0xff));
  }
  [[nodiscard]] std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325ULL;
};

/// Decimal exponent of a positive finite number: 10^e <= x < 10^(e+1), except for rounding in the last place.
int decimal_exponent(double x) { return static_cast<int>(std::floor(std::log10(x))); }

void add_position(const Vector& x, Hash& hash) {
  const double largest = x.cwiseAbs().maxCoeff();
  if (!(largest > 0) || !std::isfinite(largest)) return hash.integer(0);
  const int exponent = std::clamp(decimal_exponent(largest), -290, 300);
  const double grid = std::pow(10.0, 5 - exponent);
  hash.integer(exponent);
  for (int axis = 0; axis < 3; ++axis) {
    const double steps = std::isfinite(x[axis]) ? std::round(x[axis] * grid) : 0.0;
    hash.integer(static_cast<std::int64_t>(std::clamp(steps, -1e15, 1e15)));
  }
}

}  // namespace

std::string without_place(std::string_view message) {
  constexpr std::string_view begin = " (first in line", of = " of ";
  const auto at = message.find(begin);
  if (at == message.npos || !message.ends_with(')')) return std::string(message);
  std::string_view rest = message.substr(at + begin.size());
  if (rest.size() > 1 && rest[0] == ' ' && rest[1] >= '0' && rest[1] <= '9')
    rest.remove_prefix(std::min(rest.find_first_not_of("0123456789", 1), rest.size()));
  return rest.starts_with(of) ? std::string(message.substr(0, at)) + " (first)" : std::string(message);
}

std::uint64_t fingerprint(const Penetration& record, std::int64_t contact_id) {
  Hash hash;
  hash.integer(contact_id);
  hash.text(rule_of(record.kind).id);
  add_position(record.original, hash);
  return hash.value();
}

std::uint64_t fingerprint(const Finding& finding) {
  constexpr std::string_view mark = "line ";
  Hash hash;
  hash.integer(finding.contact);
  hash.text(finding.id);
  const std::string message = without_place(finding.message);
  std::string_view rest = message;
  for (auto at = rest.find(mark); at != rest.npos; at = rest.find(mark)) {
    hash.text(rest.substr(0, at));
    rest.remove_prefix(at + mark.size());
    rest.remove_prefix(std::min(rest.find_first_not_of("0123456789"), rest.size()));
  }
  hash.text(rest);
  return hash.value();
}

std::uint64_t fingerprint(const TieFailure& failure, std::int64_t contact_id) {
  if (failure.position) {
    Hash hash;
    hash.integer(contact_id);
    hash.text(rule_of(failure).id);
    add_position(*failure.position, hash);
    return hash.value();
  }
  Finding finding;
  finding.id = rule_of(failure).id;
  finding.message = message(failure);
  finding.contact = contact_id;
  return fingerprint(finding);
}

std::uint64_t fingerprint(const KnownFinding& known) {
  if (!known.position || known.count > 1) {
    Finding finding;
    finding.id = known.id;
    finding.message = known.message;
    finding.contact = known.contact;
    return fingerprint(finding);
  }
  Hash hash;
  hash.integer(known.contact);
  hash.text(known.id);
  add_position(*known.position, hash);
  return hash.value();
}

}  // namespace gapcheck::report
