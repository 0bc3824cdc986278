#include "reference/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "model/contact/contact_kind.hpp"

namespace gapcheck::reference {
namespace {

class Writer {
 public:
  explicit Writer(const Scene& scene) : scene_(scene) {}

  std::string all() {
    text_ = "*KEYWORD\n*MAT_ELASTIC\n1,7.85e-9,210000.0,0.3\n*MAT_RIGID\n2,7.85e-9,210000.0,0.3\n0,0,0\n\n";
    controls();
    for (const Part& part : scene_.parts) write(part);
    mesh();
    sets();
    for (const Contact& contact : scene_.contacts) write(contact);
    return text_ + "*END\n";
  }

 private:
  template <class... Args>
  void add(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
  }

  static std::string field(double value) { return value == 0 ? "" : fmt::format("{}", value); }

  /// One card with up to eight fields; zeros are left blank.
  void card(const std::vector<double>& values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (scene_.fixed_columns)
        add("{:>10}", field(values[i]));
      else
        add("{}{}", i == 0 ? "" : ",", field(values[i]));
    }
    text_ += '\n';
  }

  void controls() {
    const Controls& c = scene_.controls;
    text_ += "*CONTROL_CONTACT\n";
    card({0.1, 0, 0, double(c.shlthk), double(c.penopt), double(c.thkchg), double(c.orien), 0});
    card({0, 0, 0, 0, c.xpene, double(c.ssthk), 0, double(c.tiedprj)});
    card({0, 0, 0, 0, c.th, c.th_sf, 0, 0});
    card({double(c.ignore), 0, 0, 0, 0, 0, 0, 0});
    card({0, 0, 0, 0, 0, 0, 0, 0});
    card({double(c.shledg), 0, 0, 0, 0, 0, 0, 0});
  }

  void write(const Part& p) {
    const bool contact = p.optt != 0 || p.sft != 0;
    add("*PART{}\npart {}\n{},{},{}\n", contact ? "_CONTACT" : "", p.id, p.id, p.id, p.rigid ? 2 : 1);
    if (contact) add(",,,,{},{}\n", field(p.optt), field(p.sft));
    switch (p.kind) {
      case Kind::shell:
        return add("*SECTION_SHELL\n{},2,1.0,2\n{},{},{},{}\n", p.id, p.thickness, p.thickness, p.thickness,
                   p.thickness);
      case Kind::solid:
        return add("*SECTION_SOLID\n{},1,0\n", p.id);
      case Kind::beam:
        return add("*SECTION_BEAM\n{},1,1.0,2,1\n{},{},0.0,0.0\n", p.id, p.diameter, p.diameter);
    }
  }

  void mesh() {
    text_ += "*NODE\n";
    for (std::size_t i = 0; i < scene_.nodes.size(); ++i) {
      const Node& n = scene_.nodes[i];
      add("{},{},{},{},{}\n", i + 1, n.x.x(), n.x.y(), n.x.z(), n.tc);
    }
    for (const Element& e : scene_.elements) {
      const bool own = std::any_of(e.own.begin(), e.own.end(), [](double t) { return t != 0; });
      const char* keyword = e.kind == Kind::solid ? "SOLID" : e.kind == Kind::beam ? "BEAM" : "SHELL";
      const std::string head = fmt::format("*ELEMENT_{}{}\n", keyword, own ? "_THICKNESS" : "");
      if (head != last_) text_ += head;
      last_ = head;
      add("{:>8}{:>8}", e.id, e.part);
      for (const std::int64_t node : e.nodes) add("{:>8}", node);
      text_ += '\n';
      if (own) add("{:>16}{:>16}{:>16}{:>16}\n", field(e.own[0]), field(e.own[1]), field(e.own[2]), field(e.own[3]));
    }
  }

  void list(const char* keyword, const Set& set) {
    add("*SET_{}\n{:>10}\n", keyword, set.id);
    for (std::size_t i = 0; i < set.members.size(); ++i)
      add("{:>10}{}", set.members[i], i % 8 == 7 || i + 1 == set.members.size() ? "\n" : "");
  }

  void sets() {
    for (const Set& set : scene_.part_sets) list("PART_LIST", set);
    for (const Set& set : scene_.node_sets) list("NODE_LIST", set);
    for (const Set& set : scene_.shell_sets) list("SHELL_LIST", set);
    for (const SegmentSet& set : scene_.segment_sets) {
      add("*SET_SEGMENT\n{:>10}\n", set.id);
      for (const auto& s : set.segments) add("{:>10}{:>10}{:>10}{:>10}\n", s[0], s[1], s[2], s[3]);
    }
    for (const Box& b : scene_.boxes)
      add("*DEFINE_BOX\n{},{},{},{},{},{},{}\n", b.id, b.low.x(), b.high.x(), b.low.y(), b.high.y(), b.low.z(),
          b.high.z());
  }

  void type_card(const model::ContactKind& kind) {
    using model::TypeCards;
    switch (kind.cards) {
      case TypeCards::eroding:
        return card({0, 1, 1});
      case TypeCards::interference_card:
        return card({0, 0});
      case TypeCards::constraint:
        return card({0.5});
      case TypeCards::composite:
        return card({0, 1, 0, 0, 0});
      case TypeCards::contraction_joint:
        return card({1, 0, 0});
      case TypeCards::tiebreak:
        return card({2, 100, 100});
      case TypeCards::tiebreak_damping:
        card({2, 100, 100});
        return card({0, 0, 0});
      case TypeCards::tiebreak_user:
        card({101, 0});
        card({1});
        return card({1});
      case TypeCards::tiebreak_nodes:
        return card({100, 100, 2, 2});
      case TypeCards::tiebreak_surface:
        return card({100, 100});
      default:
        return;
    }
  }

  void write(const Contact& c) {
    const model::ContactKind& kind = *model::find_contact_kind(c.name);
    add("*CONTACT_{}{}{}_ID\n{:>10}contact {}\n", c.name, c.mortar ? "_MORTAR" : "", c.mpp ? "_MPP" : "", c.id, c.id);
    if (c.mpp) card({double(c.mpp_ignore), 0, 0, 0, 0, c.parmax, 0, 0});
    const bool single = c.b.id == 0;
    card({double(c.a.id), double(c.b.id), double(c.a.type), single ? 0.0 : double(c.b.type), double(c.a.box),
          double(c.b.box)});
    card({0, 0, 0, 0, 0, double(c.penchk), 0, 0});
    card({0, 0, c.sst, c.mst, c.sfst, c.sfmt, 0, 0});
    type_card(kind);
    const std::vector<std::vector<double>> optional{
        {double(c.soft), 0, 0, c.maxpar, 0, 0, 0, 0},
        {c.penmax, double(c.thkopt), double(c.shlthk), double(c.snlog), 0, 0, c.sldthk, 0},
        {0, double(c.ignore), 0, 0, 0, 0, 0, 0},
        {0, 0, 0, 0, 0, double(c.tcso), 0, double(c.shledg)},
        {0, 0, double(c.ipback), double(c.srnde), 0, 0, 0, 0},
        {0, double(c.ignroff), 0, 0, 0, 0, 0, 0},
    };
    std::size_t used = 0;
    for (std::size_t i = 0; i < optional.size(); ++i)
      if (std::any_of(optional[i].begin(), optional[i].end(), [](double v) { return v != 0; })) used = i + 1;
    for (std::size_t i = 0; i < used; ++i) card(optional[i]);
  }

  const Scene& scene_;
  std::string text_, last_;
};

}  // namespace

const Part& Scene::part(std::int64_t id) const {
  return *std::find_if(parts.begin(), parts.end(), [&](const Part& p) { return p.id == id; });
}

std::string Scene::text() const { return Writer(*this).all(); }

}  // namespace gapcheck::reference
