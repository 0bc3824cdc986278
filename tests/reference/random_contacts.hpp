#pragma once
#include <vector>

#include "model/contact/contact_kind.hpp"
#include "reference/random_bodies.hpp"

namespace gapcheck::reference {

/// Fills a scene with contacts of any kind and any of the values on their cards.
class ContactMaker {
 public:
  ContactMaker(Random& random, Scene& scene) : random_(random), scene_(scene) {}
  void all();

 private:
  void contact(std::int64_t id);
  void values(Contact& contact, const model::ContactKind& kind);
  void optional_values(Contact& contact, const model::ContactKind& kind);
  void tie_values(Contact& contact);
  Surface surface(const std::vector<std::int64_t>& parts, bool nodes_only);
  Surface node_set(const std::vector<std::int64_t>& parts);
  Surface segments(const std::vector<std::int64_t>& parts);
  Surface shells(const std::vector<std::int64_t>& parts);
  std::int64_t box(const std::vector<std::int64_t>& parts);
  std::int64_t next_set() { return ++sets_; }

  Random& random_;
  Scene& scene_;
  std::int64_t sets_ = 100;
};

}  // namespace gapcheck::reference
