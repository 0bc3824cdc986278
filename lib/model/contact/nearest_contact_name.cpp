#include "model/contact/nearest_contact_name.hpp"

#include <algorithm>
#include <vector>

#include "base/edit_distance.hpp"
#include "model/contact/contact_name.hpp"

namespace gapcheck::model {
namespace {

using Words = std::vector<std::string_view>;

constexpr std::size_t longest_name = 100;
/// Names that differ by a word and a half or more have nothing in common.
constexpr double too_far = 1.5;
/// A wrong letter against a wrong word, and a wrong order of words.
constexpr double letter_cost = 0.25, order_cost = 0.5;

double letters_apart(std::string_view a, std::string_view b) {
  return edit_distance(a, b, [](char x, char y) { return x == y ? 0.0 : 1.0; });
}

/// Replacing a word by one that shares no letter costs as much as removing the one and inserting the other.
double word_cost(std::string_view a, std::string_view b) {
  if (a == b) return 0;
  return 2 * letters_apart(a, b) / static_cast<double>(std::max<std::size_t>(1, std::max(a.size(), b.size())));
}

/// Names that share less than half of their letters are compared only by words.
double spelling_apart(std::string_view a, std::string_view b) {
  const double letters = letters_apart(a, b);
  return 2 * letters > static_cast<double>(std::max(a.size(), b.size())) ? too_far : letter_cost * letters;
}

/// The distance of two names, or `least` if that is less. Distances that cannot be below it are not calculated.
double names_apart(std::string_view a, std::string_view b, double least) {
  if (letter_cost * static_cast<double>(least_changed(a, b)) < least) least = std::min(least, spelling_apart(a, b));
  Words a_words = words_of(a), b_words = words_of(b);
  const auto surplus = static_cast<double>(std::max(a_words.size(), b_words.size()) -
                                           std::min(a_words.size(), b_words.size()));  // words inserted at least
  if (surplus < least) least = std::min(least, edit_distance(a_words, b_words, word_cost));
  if (surplus + order_cost >= least) return least;
  std::sort(a_words.begin(), a_words.end());
  std::sort(b_words.begin(), b_words.end());
  return std::min(least, edit_distance(a_words, b_words, word_cost) + order_cost);
}

}  // namespace

std::string nearest_contact_name(std::string_view written) {
  if (written.size() > longest_name) return {};
  constexpr std::string_view family = contact_prefix, mortar = mortar_suffix;
  const std::string bare = parse_contact_name(written).bare;
  std::string_view name = bare;
  name.remove_prefix(std::min(family.size(), name.size()));
  const bool is_mortar = name.ends_with(mortar);
  if (is_mortar) name.remove_suffix(mortar.size());
  double least = too_far;
  std::string nearest;
  for (const std::string_view known : known_contact_names()) {
    const ContactKind* kind = find_contact_kind(known);
    if (is_mortar && (kind == nullptr || !has_mortar_form(*kind))) continue;
    const double apart = names_apart(name, known, least);
    if (apart >= least) continue;
    least = apart;
    nearest = std::string(family) + std::string(known) + std::string(is_mortar ? mortar : "");
  }
  return nearest;
}

}  // namespace gapcheck::model
