#include <fmt/format.h>

#include "model/read/cards.hpp"
#include "model/read/context.hpp"
#include "model/read/field_values.hpp"

namespace gapcheck::model {
namespace {

void note_unread(std::string_view field, double value, std::string& unread) {
  if (value != 0 && unread.empty()) unread = fmt::format("{} = {:g}", field, value);
}

/// Cards 2 to 5 of 034: moduli, AOPT, then A and V.
void read_fabric(CardReader& reader, double stress, Orthotropic& data) {
  static const CardLayout eight = real_line(8, 10);
  const Card second = reader.next(eight);
  data.gab = second.real(std::size_t{0}) * stress;
  data.gbc = second.real(1) * stress;
  data.gca = second.real(2) * stress;
  data.only_tension = second.real(3) == 1;
  note_unread("EL", second.real(4), data.unread);
  note_unread("LRATIO", second.real(6), data.unread);
  note_unread("DAMP", second.real(7), data.unread);
  const Card third = reader.next(eight);
  data.aopt = third.real(std::size_t{0});
  note_unread("FORM", third.real(5), data.unread);
  if (third.real(7) != 1) note_unread("TSRFAC", third.real(7), data.unread);
  if (third.real(6) < 0) note_unread("FVOPT", third.real(6), data.unread);
  const Card fourth = reader.next(eight), fifth = reader.next(eight);
  data.a = vector_at(fourth, 3);
  data.v = vector_at(fifth, 0);
  data.beta = fifth.real(6);
  note_unread("ISREFG", fifth.real(7), data.unread);
}

/// Cards 2 to 4 of 002.
void read_elastic(CardReader& reader, double stress, Orthotropic& data) {
  static const CardLayout eight = real_line(8, 10);
  const Card second = reader.next(eight);
  data.gab = second.real(std::size_t{0}) * stress;
  data.gbc = second.real(1) * stress;
  data.gca = second.real(2) * stress;
  data.aopt = second.real(3);
  note_unread("G", second.real(4), data.unread);
  note_unread("SIGF", second.real(5), data.unread);
  const Card third = reader.next(eight), fourth = reader.next(eight);
  data.a = vector_at(third, 3);
  note_unread("MACF", third.real(6) == 1 ? 0 : third.real(6), data.unread);
  data.v = vector_at(fourth, 0);
  data.d = vector_at(fourth, 3);
  data.beta = fourth.real(6);
  note_unread("REF", fourth.real(7), data.unread);
}

}  // namespace

Orthotropic read_orthotropic(const Context& context, CardReader& reader, const Card& card, bool fabric) {
  const double stress = context.stress(reader.block(), 1);
  Orthotropic data;
  data.fabric = fabric;
  data.ea = card.real(2) * stress;
  data.eb = card.real(3) * stress;
  data.ec = fabric ? 0 : card.real(4) * stress;
  data.prba = card.real(5);
  data.prca = fabric ? 0 : card.real(6);
  data.prcb = fabric ? 0 : card.real(7);
  if (fabric)
    read_fabric(reader, stress, data);
  else
    read_elastic(reader, stress, data);
  return data;
}

}  // namespace gapcheck::model
