#include "api/convert.hpp"

#include <utility>

namespace gapcheck::api {

Severity converted(gapcheck::Severity severity) {
  switch (severity) {
    case gapcheck::Severity::note:
      return Severity::note;
    case gapcheck::Severity::warning:
      return Severity::warning;
    case gapcheck::Severity::error:
      break;
  }
  return Severity::error;
}

gapcheck::Severity converted(Severity severity) {
  switch (severity) {
    case Severity::note:
      return gapcheck::Severity::note;
    case Severity::warning:
      return gapcheck::Severity::warning;
    case Severity::error:
      break;
  }
  return gapcheck::Severity::error;
}

std::vector<Diagnostic> listed(const gapcheck::Diagnostics& diagnostics) {
  std::vector<Diagnostic> list;
  for (gapcheck::Diagnostic& each : diagnostics.sorted())
    list.push_back({converted(each.severity), std::move(each.file), each.line, std::move(each.message)});
  return list;
}

Error error_of(const gapcheck::Diagnostic& why, const gapcheck::Diagnostics& diagnostics) {
  return {why.file, why.line, why.message, listed(diagnostics)};
}

Error first_error(const gapcheck::Diagnostics& diagnostics) {
  std::vector<Diagnostic> list = listed(diagnostics);
  // With more than are kept the error itself may be among those that are not.
  if (list.empty() || list.front().severity != Severity::error)
    return {"", 0, "the input has errors behind more warnings than are kept", std::move(list)};
  Diagnostic first = std::move(list.front());
  list.erase(list.begin());
  return {std::move(first.file), first.line, std::move(first.message), std::move(list)};
}

Error plain_error(std::string message) { return {"", 0, std::move(message), {}}; }

keyword::ReadOptions read_options(const Includes& includes) {
  keyword::ReadOptions options;
  options.include_directories = includes.directories;
  options.parameters = includes.parameters;
  options.skip_missing_includes = includes.skip_missing;
  return options;
}

}  // namespace gapcheck::api
