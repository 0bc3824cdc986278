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

}  // namespace gapcheck::model
