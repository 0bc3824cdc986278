#include "report/html/html.hpp"

#include <array>
#include <span>

#include "base/embedded.hpp"
#include "report/html/html_data.hpp"

namespace gapcheck::embedded {
extern const std::span<const Text> html_files;
}  // namespace gapcheck::embedded

namespace gapcheck::report {
namespace {

std::string_view file(std::string_view name) {
  for (const embedded::Text& text : embedded::html_files)
    if (text.name == name) return text.content;
  return {};
}

/// The page's own scripts in order of dependency.
std::string scripts() {
  std::string text = "\"use strict\";\n(() => {\n";
  for (const std::string_view name :
       {"data", "dom", "chart", "matrix", "contacts", "filters", "findings", "camera", "depth", "mesh", "markers",
        "focus", "coats", "cut", "select", "overlay", "tools", "view", "main"})
    text += file(name);
  return text + "})();\n";
}

}  // namespace

std::string html(const Report& report, const NodePosition& position, const HtmlOptions& options) {
  const std::string data = html_data(report, position, options), own = scripts();
  const std::array<std::pair<std::string_view, std::string_view>, 4> pieces{{{"<!--style-->", file("style")},
                                                                             {"<!--data-->", data},
                                                                             {"<!--three-->", file("three")},
                                                                             {"<!--scripts-->", own}}};
  std::string_view rest = file("page");
  std::string page;
  page.reserve(rest.size() + data.size() + file("three").size() + file("style").size() + own.size());
  for (const auto& [mark, piece] : pieces) {
    const std::size_t at = rest.find(mark);
    if (at == std::string_view::npos) continue;
    page += rest.substr(0, at);
    page += piece;
    rest.remove_prefix(at + mark.size());
  }
  page += rest;
  return page;
}

}  // namespace gapcheck::report
