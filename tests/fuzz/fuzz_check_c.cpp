// The lines of an input as arguments of check-c, and what it then prints and exports of a log.
#include <string>

#include "check-c/arguments.hpp"
#include "fuzz.hpp"
#include "report/export/exports.hpp"
#include "samples.hpp"

namespace gapcheck::fuzz::check_c_target {
namespace {

std::vector<std::string> lines_of(std::string_view input) {
  std::vector<std::string> lines;
  while (!input.empty() && lines.size() < 50) {
    const Headed headed = fuzz::headed(input);
    lines.emplace_back(headed.head);
    input = headed.rest;
  }
  return lines;
}

}  // namespace

GAPCHECK_FUZZ_TARGET(check_c) {
  const auto parsed = check_c::parse(lines_of(input));
  if (!parsed) {
    require(!parsed.error().message.empty());
    return;
  }
  const auto& arguments = parsed.value();
  const Report picked = report::pick(sample_log(), arguments.view);
  static_cast<void>(report::check_c_text(picked, arguments.view));
  const Report shown = report::top_only(picked, arguments.view);
  if (arguments.ani || arguments.a4sel) static_cast<void>(report::animator_session(shown, arguments.a4sel));
  if (arguments.key) static_cast<void>(report::keyword_beams(shown, {}));
  if (arguments.medina) static_cast<void>(report::medina_protocol(shown, {}, arguments.medina_node));
}

}  // namespace gapcheck::fuzz::check_c_target
