#include "results/log/write_messag.hpp"

#include <fmt/format.h>

#include <iterator>

#include "results/text/fortran_number.hpp"

namespace gapcheck::results {
namespace {

using Buffer = fmt::memory_buffer;

std::string real(double value) { return scientific(value == 0 ? 0.0 : value, 11, 4); }

void coordinates(const char* which, std::int64_t node, const Vector& point, Buffer& out) {
  fmt::format_to(std::back_inserter(out), "     {} coordinates of slave node     = {}\n", which, node);
  for (int i = 0; i < 3; ++i)
    fmt::format_to(std::back_inserter(out), "     {}-coordinate                           = {}\n",
                   static_cast<char>('x' + i), real(point[i]));
}

void penetration(const Penetration& p, std::int64_t contact, Buffer& out) {
  const auto to = std::back_inserter(out);
  if (p.kind ==
      PenetrationKind::released)  // no list of the solver shows such a message: number and words are not known
    fmt::format_to(to,
                   " \n *** Warning\n     Penetrating node is released from contact since it is\n     too far below "
                   "segment.\n");
  else
    fmt::format_to(to, " \n *** Warning 40565 (SOL+565)\n     Initialization\n");
  fmt::format_to(to, "     contact interface #                    = {}\n", contact);
  fmt::format_to(to, "     penetrating node #                     = {}\n", p.node);
  fmt::format_to(to, "     segment #                              = {}\n", p.segment_number);
  fmt::format_to(to, "     penetration                            = {}\n", real(-p.depth));
  if (p.contact_distance != 0)
    fmt::format_to(to, "     remaining distance to shell midsurface = {}\n", real(p.remaining()));
  fmt::format_to(to, "     s,t                                    = {} {}\n", real(p.s), real(p.t));
  fmt::format_to(to, "     penetrated segment nodes:\n {} {} {} {}\n", p.segment[0], p.segment[1], p.segment[2],
                 p.segment[3]);
  coordinates("original", p.node, p.original, out);
  if (p.outcome == Outcome::moved) coordinates("modified", p.node, p.moved_to, out);
  if (p.recommended()) coordinates("recommended", p.node, p.moved_to, out);
}

/// The summary of a contact's initial penetrations as it follows their list.
void summary(const InitialSummary& sum, std::int64_t contact, Buffer& out) {
  const auto to = std::back_inserter(out);
  fmt::format_to(to, " summary of initial penetration for interface #= {}\n", contact);
  const auto count = [&](const char* label, std::uint64_t value) {
    fmt::format_to(to, "   {:<44}= {}\n", label, value);
  };
  count("number of warning messages", sum.messages);
  count("number of penetrating nodes", sum.nodes);
  count("number of penetrating node eliminated", sum.eliminated);
  fmt::format_to(to, "   {:<44}= {}\n", "min penetration distance", real(sum.least));
  fmt::format_to(to, "   {:<44}= {}\n", "max penetration distance", real(sum.greatest));
}

/// Header and sentence of a tie message. Reasons without a known number are recognised by their words.
const char* sentence(TieReason reason) {
  switch (reason) {
    case TieReason::not_found:
      return " 40538 (SOL+538)\n     Slave node is not constrained\n     no segment was found in bucket sort.\n";
    case TieReason::too_far:
      return " 40533 (SOL+533)\n     Slave node is not constrained since it is\n     too far from segment.\n";
    case TieReason::conflict:
      return " 40552 (SOL+552)\n     Slave node is not constrained since it is\n     already constrained.\n";
    case TieReason::too_short:
      return "\n     Slave node is not constrained since it\n     would shorten a beam.\n";
    case TieReason::rigslav:
      return "\n     Slave node is not constrained since it is\n     a node of a rigid body.\n";
    case TieReason::rigmast:
      return "\n     Slave node is not constrained since its\n     segment has a rigid node.\n";
    case TieReason::sep:
      return "\n     Slave node with a separation has been moved\n     onto its segment.\n";
    case TieReason::offset:
      return "\n     Slave node with a separation is tied and\n     not moved.\n";
  }
  return "\n";
}

void tie(const TieFailure& failure, std::int64_t contact, Buffer& out) {
  const auto to = std::back_inserter(out);
  fmt::format_to(to, " \n *** Warning{}", sentence(failure.reason));
  fmt::format_to(to, "     tied interface #           = {}\n", contact);
  fmt::format_to(to, "     slave node #               = {}\n", failure.node);
  if (failure.segment_number > 0) fmt::format_to(to, "     segment #                  = {}\n", failure.segment_number);
  if (failure.distance >= 0) fmt::format_to(to, "     separation                 = {}\n", real(failure.distance));
}

}  // namespace

std::string write_messag(const Report& report) {
  return "\n gapcheck: penetrations and ties as a messag file lists them\n" + message_blocks(report);
}

std::string message_blocks(const Report& report) {
  Buffer out;
  const auto id = [&](std::uint32_t contact) {
    return contact < report.contacts.size() ? report.contacts[contact].id : std::int64_t{0};
  };
  for (auto record = report.penetrations.begin(); record != report.penetrations.end();) {
    const std::uint32_t contact = record->contact;
    InitialSummary sum;
    for (; record != report.penetrations.end() && record->contact == contact; ++record) {
      if (!listed_by_solver(record->kind)) continue;
      penetration(*record, id(contact), out);
      sum.add({1, 1, 0, record->depth, record->depth});
    }
    if (sum.nodes > 0) summary(sum, id(contact), out);
  }
  for (const TieFailure& failure : report.tie_failures) tie(failure, id(failure.contact), out);
  return fmt::to_string(out);
}

}  // namespace gapcheck::results
