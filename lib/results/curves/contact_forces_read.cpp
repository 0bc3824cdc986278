#include <algorithm>
#include <optional>
#include <set>
#include <unordered_map>

#include "base/number.hpp"
#include "results/curves/contact_forces.hpp"
#include "results/text/printed_number.hpp"
#include "results/text/result_text.hpp"

namespace gapcheck::results {
namespace {

std::optional<std::size_t> side_of(std::string_view word) {
  if (word == "SURFA" || word == "surfa" || word == "slave" || word == "tracked") return 0;
  if (word == "SURFB" || word == "surfb" || word == "master" || word == "reference") return 1;
  return std::nullopt;
}

/// One row of rcforc: a side of a contact at one time.
struct SideRow {
  std::int64_t contact = 0;
  std::size_t side = 0;
  double time = 0;
  Vector force = Vector::Zero(), moment = Vector::Zero();
};

/// "slave 2 time 0.0 x 0.0 y 0.0 z 0.0 mass 0.0 mx 0.0 my 0.0 mz 0.0"; old files have no moments.
std::optional<SideRow> take_side_row(std::size_t side, std::string_view rest, ResultText& file) {
  SideRow row;
  row.side = side;
  const auto id = take_integer(rest);
  bool time = false;
  int forces = 0;
  for (std::string_view label = take_token(rest); !label.empty(); label = take_token(rest)) {
    const double value = file.take(rest);
    const std::size_t axis = label.size() <= 2 ? std::string_view("xyz").find(label.back()) : std::string_view::npos;
    if (label == "time") {
      row.time = value;
      time = value == value;
    } else if (axis < 3 && label.size() == 1) {
      row.force[static_cast<Eigen::Index>(axis)] = value;
      ++forces;
    } else if (axis < 3 && label.front() == 'm') {
      row.moment[static_cast<Eigen::Index>(axis)] = value;
    }
  }
  if (!id || !time || forces < 3) {
    file.unreadable();
    return std::nullopt;
  }
  row.contact = *id;
  return row;
}

/// Assembles rows into states.
class Gathered {
 public:
  explicit Gathered(InterfaceHistory& history) : history_(history) {}

  void add(const SideRow& row) {
    const bool same_time = !history_.states.empty() && history_.states.back().time == row.time;
    if (!same_time || seen(row)) begin(row.time);
    auto& contacts = history_.states.back().contacts;
    const auto [place, is_new] = places_.try_emplace(row.contact, Place{contacts.size(), {}});
    if (is_new) contacts.emplace_back().contact = row.contact;
    place->second.sides[row.side] = true;
    contacts[place->second.position].force[row.side] = row.force;
    contacts[place->second.position].moment[row.side] = row.moment;
    ++rows_;
  }

  /// The last state has fewer rows than the one before it.
  [[nodiscard]] bool cut() const { return rows_ < rows_before_; }

 private:
  struct Place {
    std::size_t position = 0;
    std::array<bool, 2> sides{};
  };

  [[nodiscard]] bool seen(const SideRow& row) const {
    const auto place = places_.find(row.contact);
    return place != places_.end() && place->second.sides[row.side];
  }

  void begin(double time) {
    history_.states.push_back({time, 0, {}});
    places_.clear();
    rows_before_ = rows_;
    rows_ = 0;
  }

  InterfaceHistory& history_;
  std::unordered_map<std::int64_t, Place> places_;
  std::size_t rows_ = 0, rows_before_ = 0;
};

/// The text after `prefix` if the line begins with it; otherwise nothing.
std::optional<std::string_view> after_prefix(std::string_view line, std::string_view prefix) {
  return line.starts_with(prefix) ? std::optional(line.substr(prefix.size())) : std::nullopt;
}

/// "10013   0.0000E+00   0.0000E+00            0.0000E+00": contact, side A, side B, friction.
void take_energies(std::string_view rest, ResultText& file, InterfaceStates& state) {
  InterfaceState contact;
  const auto id = take_integer(rest);
  if (!id) return file.unreadable();
  contact.contact = *id;
  for (double& energy : contact.energy) energy = file.take(rest);
  if (!trimmed(rest).empty()) contact.friction = file.take(rest);
  state.contacts.push_back(contact);
}

}  // namespace

InterfaceHistory read_rcforc(std::string_view text, const std::string& name, Diagnostics& diagnostics) {
  InterfaceHistory history;
  std::set<std::int64_t> single_surface;  // the file names them with every state
  Gathered states(history);
  ResultText file(text, name, diagnostics);
  for (; !file.done(); file.advance()) {
    if (file.take_legend(history.titles)) continue;
    std::string_view rest = trimmed(file.line());
    if (auto number = after_prefix(rest, "interface number,")) {
      if (const auto id = take_integer(*number)) single_surface.insert(*id);
      continue;
    }
    const auto side = side_of(take_token(rest));
    if (!side) continue;
    if (const auto row = take_side_row(*side, rest, file)) states.add(*row);
  }
  history.single_surface.assign(single_surface.begin(), single_surface.end());
  if (states.cut()) {
    history.states.pop_back();
    file.incomplete();
  }
  file.finish();
  return history;
}

InterfaceHistory read_sleout(std::string_view text, const std::string& name, Diagnostics& diagnostics) {
  InterfaceHistory history;
  ResultText file(text, name, diagnostics);
  bool open = false;  // inside a state, before its sums
  const auto drop_open = [&] {
    if (open) history.states.pop_back();
    if (open) file.incomplete();
    open = false;
  };
  for (; !file.done(); file.advance()) {
    if (file.take_legend(history.titles)) continue;
    std::string_view line = trimmed(file.line());
    if (auto rest = after_prefix(line, "contact interface energy file, time=")) {
      drop_open();
      const double time = file.take(*rest);
      open = time == time;
      if (open) history.states.push_back({time, 0, {}});
    } else if (line.starts_with("summary")) {
      open = false;
    } else if (open && line.starts_with('#')) {
      constexpr std::string_view words = "cycle=";
      std::string_view cycle = line.substr(std::min(line.find(words), line.size()));
      cycle.remove_prefix(std::min(words.size(), cycle.size()));
      const auto number = take_integer(cycle);
      if (number && *number > 0) history.states.back().cycle = static_cast<std::uint64_t>(*number);
    } else if (open && !line.empty()) {
      take_energies(line, file, history.states.back());
    }
  }
  drop_open();
  file.finish();
  return history;
}

}  // namespace gapcheck::results
