#include "keyword/known_keywords.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <span>
#include <tuple>
#include <vector>

#include "base/edit_distance.hpp"
#include "base/embedded.hpp"
#include "keyword/layout.hpp"

namespace gapcheck::embedded {
extern const std::span<const Text> known_keywords;
}

namespace gapcheck::keyword {
namespace {

using NameWords = std::vector<std::string_view>;

constexpr std::size_t longest_looked_up = 100;

NameWords split(std::string_view text, char separator) {
  NameWords words;
  for (;;) {
    const std::size_t end = std::min(text.find(separator), text.size());
    words.push_back(text.substr(0, end));
    if (end == text.size()) return words;
    text.remove_prefix(end + 1);
  }
}

std::string_view first_word(std::string_view name) { return name.substr(0, name.find('_')); }

/// All names by which keywords are judged.
struct KnownNames {
  std::set<std::string, std::less<>> names;  ///< without ID and TITLE
  std::vector<std::string_view> families;    ///< beginnings with which everything is known
  std::set<std::string_view> strict;
  std::set<std::string, std::less<>> first_words;                        ///< of all names and families
  std::map<std::string_view, std::set<std::string, std::less<>>> words;  ///< of strict families, behind the first
};

/// A name without the words ID and TITLE behind the first, and these words as they stood.
struct BareName {
  std::string bare, options;
};

BareName bare_name(std::string_view name) {
  BareName result;
  bool is_first = true;
  for (const std::string_view word : split(name, '_')) {
    std::string& to = !is_first && (word == "ID" || word == "TITLE") ? result.options : result.bare;
    if (!is_first) to += '_';
    to += word;
    is_first = false;
  }
  return result;
}

void add_line(std::string_view line, KnownNames& known) {
  NameWords words = split(line, ' ');
  if (words.size() < 2 || line.starts_with('#')) return;
  const std::string_view verb = words[0];
  words.erase(words.begin());
  if (verb == "family") known.families.insert(known.families.end(), words.begin(), words.end());
  if (verb == "strict") known.strict.insert(words.begin(), words.end());
  if (verb != "names") return;
  for (std::size_t i = 1; i < words.size(); ++i)
    known.names.insert(std::string(words[0]) + '_' + std::string(words[i]));
}

KnownNames build_names() {
  KnownNames known;
  for (const auto& text : embedded::known_keywords)
    for (const std::string_view line : split(text.content, '\n')) add_line(line, known);
  for (const std::string_view name : layout_names("")) known.names.insert(bare_name(name).bare);
  for (const std::string_view family : known.families) known.first_words.emplace(first_word(family));
  for (const std::string& name : known.names) {
    const std::string_view first = first_word(name);
    known.first_words.emplace(first);
    if (!known.strict.contains(first)) continue;
    const NameWords words = split(name, '_');
    known.words[*known.strict.find(first)].insert(words.begin() + 1, words.end());
  }
  return known;
}

const KnownNames& known_names() {
  static const KnownNames built = build_names();
  return built;
}

bool digit(char c) { return c >= '0' && c <= '9'; }

/// "024", "T01", "054/055": materials by number.
bool numbered(std::string_view word) {
  if (!word.empty() && !digit(word.front())) word.remove_prefix(1);
  return !word.empty() && digit(word.front());
}

bool of_known_family(std::string_view name) {
  const auto& families = known_names().families;
  return std::any_of(families.begin(), families.end(), [name](std::string_view family) {
    return name.starts_with(family) && (name.size() == family.size() || name[family.size()] == '_');
  });
}

/// The longest known name that the words begin with; empty: none.
std::string_view longest_known(std::string_view bare) {
  for (std::string_view name = bare; !name.empty();) {
    if (known_names().names.contains(name)) return name;
    const std::size_t cut = name.rfind('_');
    if (cut == std::string_view::npos) break;
    name = name.substr(0, cut);
  }
  return {};
}

Standing standing_of_bare(std::string_view bare) {
  const KnownNames& known = known_names();
  const std::string_view first = first_word(bare);
  if (of_known_family(bare) || known.names.contains(bare)) return Standing::known;
  const std::string_view rest = bare.substr(std::min(first.size() + 1, bare.size()));
  if (first == "MAT" && numbered(first_word(rest))) return Standing::known;
  const std::string_view beginning = longest_known(bare);
  if (beginning.empty()) return Standing::unknown;
  const auto vocabulary = known.words.find(first);
  if (vocabulary == known.words.end()) return Standing::known;
  const NameWords behind = split(bare.substr(beginning.size() + 1), '_');
  const bool usual = std::all_of(behind.begin(), behind.end(),
                                 [&](std::string_view word) { return vocabulary->second.contains(word); });
  return usual ? Standing::known : Standing::other_form;
}

/// Letters inserted, removed or replaced, and neighbours swapped, that turn one text into the other.
std::size_t letters_changed(std::string_view a, std::string_view b) {
  std::array<std::vector<std::size_t>, 3> rows;  // of the letter before the last, the last and this one
  for (auto& row : rows) row.resize(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) rows[1][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    rows[2][0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = rows[1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      rows[2][j] = std::min({rows[1][j] + 1, rows[2][j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        rows[2][j] = std::min(rows[2][j], rows[0][j - 2] + 1);
    }
    std::rotate(rows.begin(), rows.begin() + 1, rows.end());
  }
  return rows[1][b.size()];
}

/// A word of eight letters may have two wrong ones, a short one only one.
constexpr std::size_t letters_per_mistake = 4;
/// SPC, SPH and SPG are different words: in words as short as these a replaced letter makes another one.
constexpr std::size_t shortest_mistaken = 4;
constexpr std::size_t too_far = 1000;

std::size_t allowed_in(std::size_t length) { return std::max<std::size_t>(1, length / letters_per_mistake); }

/// Word by word; too_far if any is another word.
std::size_t words_apart(const NameWords& a, const NameWords& b) {
  if (a.size() != b.size()) return too_far;
  std::size_t sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] == b[i]) continue;
    if (a[i].size() == b[i].size() && a[i].size() < shortest_mistaken) return too_far;
    const std::size_t allowed = allowed_in(std::min(a[i].size(), b[i].size()));
    if (least_changed(a[i], b[i]) > allowed) return too_far;
    const std::size_t letters = letters_changed(a[i], b[i]);
    if (letters > allowed) return too_far;
    sum += letters;
  }
  return sum;
}

std::string without_digits(std::string_view text) {
  std::string result;
  std::copy_if(text.begin(), text.end(), std::back_inserter(result), [](char c) { return !digit(c); });
  return result;
}

/// How far a misspelt name is from a known one; too_far if it is another name.
std::size_t apart(std::string_view written, std::string_view known) {
  const std::size_t shorter = std::min(written.size(), known.size()), longer = std::max(written.size(), known.size());
  if (longer - shorter > allowed_in(longer) + 1) return too_far;
  NameWords a = split(written, '_'), b = split(known, '_');
  std::size_t least = words_apart(a, b);
  if (a.size() != b.size()) {
    // Missing or additional underscores.
    const std::size_t allowed = shorter > letters_per_mistake ? std::min<std::size_t>(2, allowed_in(shorter)) : 0;
    const std::size_t letters = least_changed(written, known) > allowed ? too_far : letters_changed(written, known);
    least = letters <= allowed ? letters : too_far;
  } else if (least == too_far) {
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    if (words_apart(a, b) <= 1) least = words_apart(a, b) + 2;
  }
  const bool digits_only = least != too_far && without_digits(written) == without_digits(known);
  return least > allowed_in(longer) + 1 || digits_only ? too_far : least;
}

/// The nearest of the names that it has seen.
class Nearest {
 public:
  explicit Nearest(std::string_view written) : written_(written) {}
  void see(std::size_t distance, const std::string& name) {
    if (distance >= too_far) return;
    const auto same = static_cast<std::size_t>(
        std::mismatch(written_.begin(), written_.end(), name.begin(), name.end()).first - written_.begin());
    const auto key = std::tuple(distance, name.size() + written_.size() - same, name);
    if (best_.empty() || key < key_) std::tie(key_, best_) = std::tuple(key, name);
  }
  [[nodiscard]] const std::string& name() const { return best_; }

 private:
  std::string_view written_;
  std::tuple<std::size_t, std::size_t, std::string> key_;
  std::string best_;
};

}  // namespace

Standing standing_of(std::string_view name) { return standing_of_bare(bare_name(name).bare); }

std::string known_beginning(std::string_view name) {
  const std::string bare = bare_name(name).bare;
  return standing_of_bare(bare) == Standing::other_form ? std::string(longest_known(bare)) : std::string();
}

std::string nearest_keyword(std::string_view name) {
  if (name.size() > longest_looked_up) return {};
  const auto [bare, options] = bare_name(name);
  const KnownNames& known = known_names();
  Nearest nearest(bare);
  const std::string first(first_word(bare)), rest = bare.substr(first.size());
  for (const std::string& other : known.first_words) {
    const std::string corrected = other + rest;
    if (other != first && standing_of_bare(corrected) == Standing::known)
      nearest.see(words_apart({first}, {other}), corrected);
  }
  for (const std::string& other : known.names) nearest.see(apart(bare, other), other);
  return nearest.name().empty() ? std::string() : nearest.name() + options;
}

}  // namespace gapcheck::keyword
