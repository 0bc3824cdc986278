#pragma once
#include <functional>

#include "api/convert.hpp"
#include "base/work_watch.hpp"

namespace gapcheck::api {

/// The result of work that asks `watch` now and then whether to go on. Once it has said no, the result is the error
/// `stopped`, whatever the work gives.
template <class Work>
[[nodiscard]] auto watched(const std::function<bool()>& watch, const char* stopped, const Work& work) {
  const WorkWatch asked(watch);
  auto result = work();
  if (asked.stopped()) result = plain_error(stopped);
  return result;
}

}  // namespace gapcheck::api
