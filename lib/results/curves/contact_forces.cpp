#include "results/curves/contact_forces.hpp"

#include <fmt/format.h>

#include "results/text/fortran_number.hpp"

namespace gapcheck::results {

std::string contact_header(const FileHeader& header, std::vector<LegendEntry> contacts) {
  return header_text(header) + legend_text(std::move(contacts), 69) + "\n";
}

std::string rcforc_text(double time, std::span<const InterfaceState> contacts) {
  std::string text;
  for (const InterfaceState& contact : contacts)
    for (std::size_t side = 0; side < 2; ++side) {
      if (contact.single_surface) {
        text += fmt::format(" interface number,{:10},is single surface-resultants are undefined\n", contact.contact);
        continue;
      }
      const Vector &f = contact.force[side], &m = contact.moment[side];
      const auto e = [](double value) { return scientific(value, 12, 5); };
      text +=
          fmt::format("  SURF{}{:12} time{}  x {}  y {}  z {} mass {}  mx {}  my {}  mz {}\n", side == 0 ? 'A' : 'B',
                      contact.contact, e(time), e(f.x()), e(f.y()), e(f.z()), e(0), e(m.x()), e(m.y()), e(m.z()));
    }
  return text;
}

std::string sleout_text(double time, std::uint64_t cycle, std::span<const InterfaceState> contacts) {
  std::string text;
  static_cast<void>(write_sleout(time, cycle, contacts, [&](std::string_view piece) {
    text += piece;
    return true;
  }));
  return text;
}

bool write_sleout(double time, std::uint64_t cycle, std::span<const InterfaceState> contacts,
                  const std::function<bool(std::string_view)>& write) {
  constexpr std::size_t piece = std::size_t{1} << 17;
  std::string text = fmt::format("\n\n\n contact interface energy file, time={}\n", normalised(time, 14, 7));
  text += fmt::format("    #             surfa       surfb        cycle={:14}    frictional\n\n", cycle);
  std::array<double, 2> sides{};
  double friction = 0;
  for (const InterfaceState& contact : contacts) {
    for (std::size_t side = 0; side < 2; ++side) sides[side] += contact.energy[side];
    friction += contact.friction;
    text += fmt::format("{:10}{}{}{:28}{}\n", contact.contact, normalised(contact.energy[0], 13, 4),
                        normalised(contact.energy[1], 13, 4), "", normalised(contact.friction, 13, 4));
    if (text.size() < piece) continue;
    if (!write(text)) return false;
    text.clear();
  }
  const auto sum = [](double value) { return normalised(value, 14, 7); };
  text += fmt::format(
      "\n summary   total surfa side={}\n           total surfb side={}\n           total energy    ={}\n"
      "           friction energy ={}\n\n\n\n",
      sum(sides[0]), sum(sides[1]), sum(sides[0] + sides[1]), sum(friction));
  return write(text);
}

std::string ncforc_text(double time, std::int64_t contact, std::span<const NodeForce> nodes) {
  std::string text;
  for (std::size_t side = 0; side < 2; ++side) {
    std::string rows;
    const auto add = [&](std::initializer_list<double> values) {
      for (const double value : values) rows += scientific(value, 14, 5);
      rows += '\n';
    };
    for (const NodeForce& node : nodes) {
      if (node.side != side) continue;
      rows += fmt::format("{:10}      ", node.node);
      add({node.force.x(), node.force.y(), node.force.z(), node.pressure});
      rows += std::string(16, ' ');
      add({node.position.x(), node.position.y(), node.position.z()});
    }
    if (rows.empty()) continue;
    text += fmt::format("\n\n\n forces (t={}) for interface{:10} {} side\n\n", scientific(time, 11, 5), contact,
                        side == 0 ? "slave " : "master");
    text += "     node           x-force/      y-force/      z-force/     pressure/\n";
    text += "                   coordinate    coordinate    coordinate\n" + rows;
  }
  return text;
}

}  // namespace gapcheck::results
