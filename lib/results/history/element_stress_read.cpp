#include "base/number.hpp"
#include "results/history/element_stress.hpp"
#include "results/text/printed_number.hpp"

namespace gapcheck::results {
namespace {

constexpr std::size_t columns_of_state = 17;  ///< before the numbers of shells and solids

/// "     101-      7" begins a shell or solid.
bool begins_element(std::string_view line, ElementStress& element) {
  const std::size_t dash = line.find('-');
  if (dash == std::string_view::npos) return false;
  const auto id = parse_integer(trimmed(line.substr(0, dash))), part = parse_integer(trimmed(line.substr(dash + 1)));
  if (!id || !part) return false;
  element.id = *id;
  element.part = *part;
  return true;
}

class EloutReader {
 public:
  EloutReader(ResultText& file, History<ElementStress>& history) : file_(file), history_(history) {}

  void line() {
    const std::string_view line = trimmed(file_.line());
    std::string_view time = behind(line, "( at time");
    // Other blocks of numbers are strains.
    if (!time.empty() || line.starts_with("strains")) rows_ = Rows::none;
    if (line.starts_with("e l e m e n t   s t r e s s") || line.starts_with("r e s u l t a n t s"))
      history_.at(file_.take(time));
    if (line.starts_with("ipt-shl")) return begin(Rows::elements, StressKind::shell);
    if (line.starts_with("ipt ")) return begin(Rows::elements, StressKind::solid);
    if (line.starts_with("beam/truss")) return begin_beam(line);
    if (line.starts_with("resultants")) return begin(Rows::resultants, StressKind::beam);
    if (line.starts_with("integration point stresses")) return begin(Rows::beam_points, StressKind::beam);
    if (!line.empty()) row(line);
  }

 private:
  enum class Rows : std::uint8_t { none, elements, resultants, beam_points };

  void begin(Rows rows, StressKind kind) {
    rows_ = rows;
    kind_ = kind;
  }
  void begin_beam(std::string_view line) {
    std::string_view id_text = behind(line, "="), part_text = behind(id_text, "=");
    const auto id = take_integer(id_text), part = take_integer(part_text);
    rows_ = Rows::none;
    if (!id || !part) return file_.unreadable();
    history_.add({StressKind::beam, *id, *part, {}, {}, 1});
  }

  void row(std::string_view line) {
    if (history_.states.empty() || rows_ == Rows::none) return;
    ElementStress element;
    if (rows_ == Rows::elements && begins_element(line, element)) {
      element.kind = kind_;
      return history_.add(element);
    }
    auto& elements = history_.states.back().rows;
    if (elements.empty() || elements.back().kind != kind_) return;
    ElementStress& last = elements.back();
    if (rows_ == Rows::resultants) {
      std::string_view rest = line;
      for (double& value : last.resultants) value = file_.take(rest);
      rows_ = Rows::none;
    } else if (rows_ == Rows::beam_points) {
      beam_point(line, last);
    } else if (line.find("state") == std::string_view::npos) {
      point(line, last);
    }
  }

  void beam_point(std::string_view rest, ElementStress& beam) {
    if (rest.starts_with("sigma")) return;
    if (!take_integer(rest)) return file_.unreadable();
    StressRow row;
    for (const std::size_t component : {0, 3, 5}) row.stress[component] = file_.take(rest);
    row.plastic_strain = file_.take(rest);
    beam.points.push_back(row);
  }

  void point(std::string_view line, ElementStress& element) {
    std::string_view rest = behind_columns(file_.line(), columns_of_state);
    StressRow row;
    row.plastic = line.find("plastic") != std::string_view::npos;
    for (double& stress : row.stress) stress = file_.take(rest);
    if (element.kind == StressKind::solid) row.effective = file_.take(rest);
    row.plastic_strain = file_.take(rest);
    element.points.push_back(row);
    if (element.kind == StressKind::shell)
      if (const auto layer = take_integer(line))
        element.layers = std::max(element.layers, static_cast<std::size_t>(std::max<std::int64_t>(*layer, 1)));
  }

  ResultText& file_;
  History<ElementStress>& history_;
  Rows rows_ = Rows::none;
  StressKind kind_ = StressKind::shell;
};

}  // namespace

History<ElementStress> read_elout(std::string_view text, const std::string& name, Diagnostics& diagnostics) {
  History<ElementStress> history;
  ResultText file(text, name, diagnostics);
  EloutReader reader(file, history);
  for (; !file.done(); file.advance())
    if (!file.take_legend(history.titles)) reader.line();
  history.end(file);
  file.finish();
  return history;
}

}  // namespace gapcheck::results
