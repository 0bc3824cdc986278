#include "model/contact/contact.hpp"

#include <utility>

namespace gapcheck::model {

void set_name(std::string_view written, Contact& contact) {
  ContactName name = parse_contact_name(written);
  contact.written = written;
  contact.keyword = std::move(name.bare);
  contact.kind = name.kind;
  contact.options = name.options;
  contact.known = name.known();
  contact.own_layout = name.own_layout;
}

bool same_cards(const Contact& a, const Contact& b) {
  Contact like_a = b;
  like_a.id = a.id;
  like_a.order = a.order;
  like_a.default_id = a.default_id;
  like_a.title = a.title;
  like_a.place = a.place;
  like_a.lines = a.lines;
  like_a.cards.first_surplus = a.cards.first_surplus;
  like_a.cards.misread = a.cards.misread;
  return like_a == a;
}

}  // namespace gapcheck::model
