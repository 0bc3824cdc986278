#include "records/fix_proof.hpp"

namespace gapcheck {

std::uint64_t RunTrial::forced_at_start() const {
  std::uint64_t sum = 0;
  for (const StartContact& contact : start.contacts) sum += contact.forced;
  return sum;
}

std::uint64_t RunTrial::released_at_start() const {
  std::uint64_t sum = 0;
  for (const StartContact& contact : start.contacts) sum += contact.released;
  return sum;
}

bool FixProof::holds() const {
  return after.ran && !after.failed && starts_clean(after.start) && after.forced_at_start() == 0;
}

}  // namespace gapcheck
