#pragma once
#include <map>
#include <memory>
#include <utility>

namespace gapcheck {

/// Values in use, by key: who asks for one that somebody still holds shares it. Does not keep them. Not for use from
/// several threads.
template <class Key, class Value>
class WeakCache {
 public:
  /// `make`: returns a std::unique_ptr to a new one.
  template <class Make>
  [[nodiscard]] std::shared_ptr<const Value> at(const Key& key, const Make& make) {
    std::weak_ptr<const Value>& known = values_[key];
    if (std::shared_ptr<const Value> shared = known.lock()) return shared;
    // Not by std::make_shared(), whose memory would stay as long as the entry.
    std::shared_ptr<const Value> shared{std::unique_ptr<const Value>(make())};
    known = shared;
    return shared;
  }
  void clear() { values_.clear(); }

 private:
  std::map<Key, std::weak_ptr<const Value>> values_;
};

}  // namespace gapcheck
