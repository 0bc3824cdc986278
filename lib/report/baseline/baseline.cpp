#include "report/baseline/baseline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <tuple>

#include "report/baseline/baseline_match.hpp"
#include "report/item/describe.hpp"
#include "report/item/fingerprint.hpp"
#include "report/item/item.hpp"
#include "report/write/json_members.hpp"

namespace gapcheck::report {
namespace {

constexpr std::string_view schema = "gapcheck-baseline/1";

/// Six significant digits; NaN or negative values are unknown.
double six_digits(double value) {
  if (!(value >= 0) || !std::isfinite(value)) return -1;
  return std::strtod(fmt::format("{:.5e}", value).c_str(), nullptr);
}

/// Six significant digits of the largest coordinate, as many decimals for the others.
std::optional<Vector> rounded(const Vector& x) {
  const double largest = x.cwiseAbs().maxCoeff();
  if (!x.allFinite()) return std::nullopt;
  Vector result = Vector::Zero();
  if (largest == 0) return result;
  const int decimals = std::clamp(5 - static_cast<int>(std::floor(std::log10(largest))), -300, 300);
  const double step = std::pow(10.0, std::abs(decimals));
  for (int axis = 0; axis < 3; ++axis) {
    const double value = decimals >= 0 ? std::round(x[axis] * step) / step : std::round(x[axis] / step) * step;
    result[axis] = std::isfinite(value) ? value + 0.0 : x[axis];  // + 0: one zero only
  }
  return result;
}

/// Line numbers do not identify a finding: "line 12" becomes "line".
std::string without_lines(std::string_view text) {
  constexpr std::string_view mark = "line ";
  std::string out;
  for (auto at = text.find(mark); at != text.npos; at = text.find(mark)) {
    out += text.substr(0, at + mark.size() - 1);
    text.remove_prefix(at + mark.size());
    text.remove_prefix(std::min(text.find_first_not_of("0123456789"), text.size()));
  }
  return out += text;
}

KnownFinding known_finding(const Item& item) {
  KnownFinding known;
  known.id = item.id;
  known.rule = item.rule;
  known.severity = item.severity;
  known.contact = item.contact;
  if (item.position) known.position = rounded(*item.position);
  known.penetration = six_digits(item.penetration);
  known.contact_distance = six_digits(item.contact_distance);
  known.segment_size = six_digits(item.segment_size);
  known.count = item.count;
  // As in the file: bytes that are not UTF-8 are not preserved.
  if (!known.position || known.count > 1)
    known.message = nlohmann::json::parse(json_string(without_lines(without_place(item.message)))).get<std::string>();
  return known;
}

/// One line. The error says what is wrong with it.
Result<KnownFinding> read_line(std::string_view line) {
  KnownFinding finding;
  const nlohmann::json json = nlohmann::json::parse(line, nullptr, false);
  if (!json.is_object()) return plain_error("this is no JSON object");
  std::string wrong;
  const auto member = [&](const char* key, bool needed, const auto& read) {
    const auto found = json.find(key);
    if (found == json.end() ? needed : !read(*found))
      if (wrong.empty()) wrong = fmt::format("\"{}\" is missing or not what it should be", key);
  };
  const auto text = [](std::string& into) {
    return
        [&into](const nlohmann::json& value) { return value.is_string() && (into = value.get<std::string>(), true); };
  };
  const auto length = [](double& into) {
    return [&into](const nlohmann::json& value) {
      return value.is_number() && (into = value.get<double>()) >= 0 && std::isfinite(into);
    };
  };
  member("id", true, text(finding.id));
  member("rule", true, text(finding.rule));
  member("severity", true, [&](const nlohmann::json& value) {
    for (const Severity severity : {Severity::note, Severity::warning, Severity::error})
      if (value == std::string(name(severity))) return finding.severity = severity, true;
    return false;
  });
  member("contact", false, [&](const nlohmann::json& value) {
    return value.is_number_integer() && !(value.is_number_unsigned() && value.get<std::uint64_t>() >> 63 != 0) &&
           (finding.contact = value.get<std::int64_t>(), true);
  });
  member("position", false, [&](const nlohmann::json& value) {
    if (!value.is_array() || value.size() != 3) return false;
    Vector x;
    for (int axis = 0; axis < 3; ++axis) {
      if (!value[static_cast<std::size_t>(axis)].is_number()) return false;
      x[axis] = value[static_cast<std::size_t>(axis)].get<double>() + 0.0;
    }
    finding.position = x;
    return x.allFinite();
  });
  member("penetration", false, length(finding.penetration));
  member("contact_distance", false, length(finding.contact_distance));
  member("segment_size", false, length(finding.segment_size));
  member("count", false, [&](const nlohmann::json& value) {
    return value.is_number_unsigned() && (finding.count = value.get<std::uint64_t>()) > 1;
  });
  member("message", false, text(finding.message));
  finding.message = without_place(finding.message);
  if (wrong.empty() && !finding.position && finding.message.empty())
    wrong = "there is neither \"position\" nor \"message\"";
  if (!wrong.empty()) return plain_error(std::move(wrong));
  return finding;
}

/// Worse than in the baseline.
bool worse(const KnownFinding& before, const KnownFinding& now) {
  if (degree_of(now.id).degree != degree_of(before.id).degree)
    return degree_of(now.id).degree > degree_of(before.id).degree;
  if (now.severity != before.severity) return now.severity > before.severity;
  if (now.count > before.count) return true;
  if (before.penetration < 0 || now.penetration < 0) return false;
  const double measure = before.contact_distance > 0 ? before.contact_distance : before.penetration;
  return now.penetration > before.penetration + 0.01 * measure;
}

}  // namespace

std::vector<KnownFinding> known_findings(const Report& report) {
  std::vector<KnownFinding> known;
  known.reserve(report.penetrations.size() + report.tie_failures.size() + report.findings.size());
  for_each_item(report, [&](const Item& item) {
    known.push_back(known_finding(item));
    return true;
  });
  return known;
}

void append_known(const KnownFinding& finding, Buffer& out) {
  Members object(out);
  object.string("id", finding.id);
  object.string("rule", finding.rule);
  object.plain("severity", name(finding.severity));
  if (finding.contact != 0) object.integer("contact", finding.contact);
  if (finding.position)
    object.array("position", std::array{finding.position->x(), finding.position->y(), finding.position->z()});
  if (finding.penetration >= 0) object.number("penetration", finding.penetration);
  if (finding.contact_distance >= 0) object.number("contact_distance", finding.contact_distance);
  if (finding.segment_size >= 0) object.number("segment_size", finding.segment_size);
  if (finding.count > 1) object.integer("count", finding.count);
  if (!finding.message.empty()) object.string("message", finding.message);
  object.close();
}

std::string baseline_text(std::vector<KnownFinding> findings) {
  const auto key = [](const KnownFinding& f) {
    const Vector x = f.position.value_or(Vector::Zero());
    return std::tuple(f.contact, std::string_view(f.id), x[0], x[1], x[2], f.penetration, std::string_view(f.message),
                      f.count, f.contact_distance, f.segment_size, f.severity);
  };
  std::sort(findings.begin(), findings.end(),
            [&](const KnownFinding& a, const KnownFinding& b) { return key(a) < key(b); });
  Buffer text;
  fmt::format_to(fmt::appender(text), "{{\"schema\":\"{}\"}}\n", schema);
  for (const KnownFinding& finding : findings) {
    append_known(finding, text);
    text.push_back('\n');
  }
  return fmt::to_string(text);
}

Result<std::vector<KnownFinding>> read_baseline(std::string_view text, const std::string& name) {
  std::vector<KnownFinding> findings;
  std::uint32_t number = 0;
  const auto error = [&](std::string what) {
    what += "; write the baseline anew with --write-baseline";
    return Diagnostic{Severity::error, name, number, std::move(what)};
  };
  constexpr std::size_t longest = 1 << 20;
  while (!text.empty()) {
    ++number;
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.size() > longest) return error("the line is longer than a megabyte");
    if (number == 1) {
      const nlohmann::json json = nlohmann::json::parse(line, nullptr, false);
      if (!json.is_object() || !json.contains("schema") || json["schema"] != std::string(schema))
        return error(fmt::format("this is not a baseline: the first line must be {{\"schema\":\"{}\"}}", schema));
      continue;
    }
    if (line.find_first_not_of(" \t\r") == line.npos) continue;
    auto finding = read_line(line);
    if (!finding) return error(finding.error().message);
    findings.push_back(std::move(finding).value());
  }
  if (number == 0) return error("the file is empty");
  return findings;
}

BaselineComparison compare_with_baseline(const Report& report, const std::vector<KnownFinding>& baseline,
                                         const LookedFor& looked_for) {
  std::vector<KnownFinding> now = known_findings(report);
  const std::size_t shown = now.size();
  // What is now ignored is not gone.
  for_each_ignored(report, [&](const Item& item) {
    now.push_back(known_finding(item));
    return true;
  });
  const std::vector<std::uint32_t> match = match_findings(baseline, now, shown);
  std::vector<BaselineState> states(now.size(), BaselineState::fresh);
  std::vector<bool> there(baseline.size());
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (match[i] == unmatched) continue;
    there[match[i]] = true;
    states[i] = worse(baseline[match[i]], now[i]) ? BaselineState::worse : BaselineState::unchanged;
  }
  BaselineComparison comparison;
  const auto first_ignored = states.begin() + static_cast<std::ptrdiff_t>(shown);
  comparison.states.assign(states.begin(), first_ignored);
  comparison.ignored_states.assign(first_ignored, states.end());
  for (std::size_t i = 0; i < baseline.size(); ++i)
    if (!there[i] && looked_for(baseline[i])) comparison.gone.push_back(baseline[i]);
  return comparison;
}

std::string describe(const KnownFinding& finding) {
  std::string text = fmt::format("{} {}:", finding.id, finding.rule);
  if (finding.contact != 0) text += fmt::format(" contact {}", finding.contact);
  if (finding.position) {
    const Vector& x = *finding.position;
    text += fmt::format(" at {} {} {}", x[0], x[1], x[2]);
  }
  if (finding.penetration >= 0) text += fmt::format(", penetration {}", finding.penetration);
  const bool placed = finding.contact != 0 || finding.position;
  if (!finding.message.empty()) text += (placed ? ": " : " ") + finding.message;
  return text;
}

BaselineCounts counts(const BaselineComparison& comparison) {
  using enum BaselineState;
  return {comparison.count(fresh), comparison.count(worse), comparison.count(unchanged), comparison.gone.size()};
}

std::optional<BaselineCounts> baseline_counts(const Reports& reports) {
  std::optional<BaselineCounts> sum;
  for (const Report& report : reports.all) {
    if (!report.baseline) continue;
    if (!sum) sum.emplace();
    const BaselineCounts own = counts(*report.baseline);
    sum->fresh += own.fresh;
    sum->worse += own.worse;
    sum->unchanged += own.unchanged;
    sum->gone += own.gone;
  }
  return sum;
}

std::string summary(const BaselineCounts& counts) {
  return fmt::format("{} new, {} worse, {} unchanged, {} gone", counts.fresh, counts.worse, counts.unchanged,
                     counts.gone);
}

std::string summary(const BaselineComparison& comparison) { return summary(counts(comparison)); }

}  // namespace gapcheck::report
