#include "results/log/message_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace gapcheck::results {
namespace {

/// Memory is bounded: texts beyond this number are no longer distinguished.
constexpr std::size_t most_texts = 1'000'000;
constexpr std::size_t most_groups = 2'000;
constexpr std::size_t most_codes = 100'000;

}  // namespace

bool MessageLog::count(Severity severity, std::int64_t code, const std::string& kind, std::uint64_t hash,
                       std::uint32_t file) {
  Key key(code, severity, kind);
  auto found = groups_.find(key);
  if (found == groups_.end()) {
    if (groups_.size() >= most_groups) key = Key(0, severity, "");
    found = groups_.try_emplace(std::move(key)).first;
  }
  last_ = &found->second;
  auto known = last_->texts.find(hash);
  if (known == last_->texts.end()) {
    if (texts_ >= most_texts && last_->kept.size() >= kept_texts) {
      last_->overflow.add(file);
      return false;
    }
    ++texts_;
    const auto position = static_cast<std::uint32_t>(std::min(last_->kept.size(), kept_texts));
    known = last_->texts.emplace(hash, Tally{0, 0, file, position}).first;
    known->second.add(file);
    return position < kept_texts;
  }
  known->second.add(file);
  return false;
}

void MessageLog::keep(SolverMessage message) { last_->kept.push_back(std::move(message)); }

void MessageLog::count_block(std::int64_t code) {
  if (blocks_.size() < most_codes || blocks_.contains(code)) ++blocks_[code];
}

bool MessageLog::any_block_counted(std::uint64_t limit) const {
  return std::any_of(blocks_.begin(), blocks_.end(), [&](const auto& block) { return block.second == limit; });
}

std::vector<SolverMessage> MessageLog::take() {
  std::vector<SolverMessage> messages;
  for (auto& [key, group] : groups_) {
    std::uint64_t rest = group.overflow.most;
    for (const auto& [hash, tally] : group.texts) {
      if (tally.position < group.kept.size())
        group.kept[tally.position].count = tally.most;
      else
        rest += tally.most;
    }
    std::sort(group.kept.begin(), group.kept.end(), [](const SolverMessage& a, const SolverMessage& b) {
      return std::tie(a.file, a.line) < std::tie(b.file, b.line);
    });
    if (rest > 0 && !group.kept.empty()) {
      SolverMessage others = group.kept.back();
      others.text = "more texts of this number, counted only";
      others.count = rest;
      others.line = 0;
      group.kept.push_back(std::move(others));
    }
    std::move(group.kept.begin(), group.kept.end(), std::back_inserter(messages));
  }
  groups_.clear();
  last_ = nullptr;
  return messages;
}

}  // namespace gapcheck::results
