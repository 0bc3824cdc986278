#include "reference/random_contacts.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace gapcheck::reference {
namespace {

using model::ContactKind;
using model::Treatment;

bool contains(const std::vector<std::int64_t>& list, std::int64_t id) {
  return std::find(list.begin(), list.end(), id) != list.end();
}

/// Ties that the audit judges, but those of single surfaces; and all that do not tie.
bool judged(const ContactKind& kind) {
  using model::TieForm;
  if (!kind.ties()) return true;
  return kind.treatment != Treatment::single_surface && kind.tie != TieForm::automatic_tied &&
         kind.tie != TieForm::weld;
}

/// One kind of each code is as likely as another, whatever the number of its keywords.
std::vector<std::vector<const ContactKind*>> kinds_by_code() {
  std::vector<std::vector<const ContactKind*>> kinds;
  for (const ContactKind& kind : model::contact_kinds()) {
    if (kind.treatment == Treatment::none || kind.family == model::Family::other || !judged(kind)) continue;
    const ContactKind* last = kinds.empty() ? nullptr : kinds.back().front();
    // Forms of ties and tiebreaks are kinds of their own.
    const bool alike = last != nullptr && last->code == kind.code && last->ties() == kind.ties() &&
                       (!kind.ties() || last->offset == kind.offset);
    if (!alike) kinds.emplace_back();
    kinds.back().push_back(&kind);
  }
  return kinds;
}

}  // namespace

void ContactMaker::all() {
  const int count = random_.pick(1, 3);
  for (int i = 0; i < count; ++i) contact(10 * (i + 1));
}

void ContactMaker::contact(std::int64_t id) {
  static const auto kinds = kinds_by_code();
  const auto& alike = kinds[std::size_t(random_.pick(0, int(kinds.size()) - 1))];
  const ContactKind& kind = *alike[std::size_t(random_.chance(0.7) ? 0 : random_.pick(0, int(alike.size()) - 1))];
  Contact c;
  c.id = id;
  c.name = kind.name;
  const bool nodes = c.name.find("NODES_TO") != std::string::npos || c.name.find("BEAMS_TO") != std::string::npos ||
                     c.name.find("NODES_ONLY") != std::string::npos || c.name.find("SPOTWELD") != std::string::npos;
  c.mortar = !nodes && !kind.ties() && model::has_mortar_form(kind) && random_.chance(0.12);
  std::vector<std::int64_t> a, b;
  // Oriented surfaces mostly lie above one another, so that it is clear which way they face.
  const bool oriented = kind.family == model::Family::old || kind.family == model::Family::forming;
  const bool layers = oriented && random_.chance(0.8), up = random_.chance(0.5);
  const int cut = random_.pick(1, int(scene_.parts.size()) - 1);
  for (const Part& p : scene_.parts) ((layers ? (p.id > cut) == up : random_.chance(0.5)) ? a : b).push_back(p.id);
  if (kind.treatment == Treatment::single_surface) {
    a.clear();
    for (const Part& p : scene_.parts) a.push_back(p.id);
    if (random_.chance(0.3))
      c.a = {0, random_.chance(0.5) ? 5 : 2, 0};
    else
      c.a = surface(a, false);
  } else {
    if (a.empty()) a.push_back(b.back()), b.pop_back();
    if (b.empty()) b.push_back(a.back()), a.pop_back();
    c.a = (nodes || kind.ties()) && random_.chance(0.6) ? node_set(a) : surface(a, nodes);
    c.b = surface(b, false);
  }
  values(c, kind);
  optional_values(c, kind);
  if (kind.ties()) tie_values(c);
  scene_.contacts.push_back(c);
}

Surface ContactMaker::surface(const std::vector<std::int64_t>& parts, bool nodes_only) {
  const bool shells_only =
      std::all_of(parts.begin(), parts.end(), [&](std::int64_t id) { return scene_.part(id).kind == Kind::shell; });
  const double form = random_.uniform(0, 1);
  Surface s;
  if (form < 0.15 && !nodes_only) return segments(parts);
  if (form < 0.3 && shells_only) return shells(parts);
  if (parts.size() == 1 && random_.chance(0.7)) {
    s = {parts[0], 3, 0};
  } else {
    Set set;
    set.id = next_set();
    s = {set.id, random_.chance(0.15) ? 6 : 2, 0};
    for (const Part& p : scene_.parts)
      if (contains(parts, p.id) == (s.type == 2)) set.members.push_back(p.id);
    if (set.members.empty()) set.members = parts, s.type = 2;
    scene_.part_sets.push_back(set);
  }
  if (random_.chance(0.08)) s.box = box(parts);
  return s;
}

Surface ContactMaker::node_set(const std::vector<std::int64_t>& parts) {
  std::set<std::int64_t> members;
  for (const Element& e : scene_.elements)
    if (contains(parts, e.part)) members.insert(e.nodes.begin(), e.nodes.end());
  Set set{next_set(), {members.begin(), members.end()}};
  // Sometimes with nodes that no element has.
  if (random_.chance(0.15)) {
    const Vector beside = scene_.nodes[std::size_t(*members.begin() - 1)].x;
    for (int i = 0; i < 3; ++i) {
      const Vector x = beside + Vector(random_.uniform(-1, 1), random_.uniform(-1, 1), random_.uniform(-1, 1));
      scene_.nodes.push_back({x.unaryExpr([](double v) { return std::round(v * 0x1p20) * 0x1p-20; }), 0});
      set.members.push_back(static_cast<std::int64_t>(scene_.nodes.size()));
    }
  }
  scene_.node_sets.push_back(set);
  return {set.id, 4, 0};
}

/// All shells and all sides of bricks that nobody shares, as they are numbered.
Surface ContactMaker::segments(const std::vector<std::int64_t>& parts) {
  constexpr std::size_t faces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                       {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  std::map<std::set<std::int64_t>, int> uses;
  SegmentSet set;
  set.id = next_set();
  const auto face = [&](const Element& e, std::size_t f) {
    return std::array{e.nodes[faces[f][0]], e.nodes[faces[f][1]], e.nodes[faces[f][2]], e.nodes[faces[f][3]]};
  };
  for (const Element& e : scene_.elements)
    if (e.kind == Kind::solid)
      for (std::size_t f = 0; f < 6; ++f) {
        const auto n = face(e, f);
        ++uses[{n.begin(), n.end()}];
      }
  const bool upper_only = random_.chance(0.4);
  for (const Element& e : scene_.elements) {
    if (!contains(parts, e.part)) continue;
    if (e.kind == Kind::shell) set.segments.push_back({e.nodes[0], e.nodes[1], e.nodes[2], e.nodes[3]});
    if (e.kind == Kind::solid)
      for (std::size_t f = 0; f < (upper_only ? 2 : 6); ++f)
        if (const auto n = face(e, f); uses[{n.begin(), n.end()}] == 1) set.segments.push_back(n);
  }
  if (set.segments.empty()) {
    scene_.part_sets.push_back({next_set(), parts});
    return {sets_, 2, 0};
  }
  scene_.segment_sets.push_back(set);
  return {set.id, 0, 0};
}

Surface ContactMaker::shells(const std::vector<std::int64_t>& parts) {
  Set set{next_set(), {}};
  for (const Element& e : scene_.elements)
    if (contains(parts, e.part)) set.members.push_back(e.id);
  scene_.shell_sets.push_back(set);
  return {set.id, 1, 0};
}

/// Around the parts, without one corner of space.
std::int64_t ContactMaker::box(const std::vector<std::int64_t>& parts) {
  Box box;
  box.id = static_cast<std::int64_t>(scene_.boxes.size()) + 1;
  box.low = Vector::Constant(1e9), box.high = Vector::Constant(-1e9);
  for (const Element& e : scene_.elements) {
    if (!contains(parts, e.part)) continue;
    for (const std::int64_t n : e.nodes) {
      const Vector& x = scene_.nodes[std::size_t(n - 1)].x;
      box.low = box.low.cwiseMin(x), box.high = box.high.cwiseMax(x);
    }
  }
  box.low -= Vector::Constant(0.5), box.high += Vector::Constant(0.5);
  const int axis = random_.pick(0, 1);
  box.high[axis] -= random_.rounded(0.2, 0.6) * (box.high[axis] - box.low[axis]);
  for (int i = 0; i < 3; ++i)
    box.low[i] = std::round(box.low[i] * 1000) / 1000, box.high[i] = std::round(box.high[i] * 1000) / 1000;
  scene_.boxes.push_back(box);
  return box.id;
}

void ContactMaker::values(Contact& c, const ContactKind&) {
  if (random_.chance(0.2)) c.sst = random_.rounded(0.2, 1.2);
  if (random_.chance(0.2)) c.mst = random_.rounded(0.2, 1.2);
  if (random_.chance(0.2)) c.sfst = random_.rounded(0.5, 1.5);
  if (random_.chance(0.2)) c.sfmt = random_.rounded(0.5, 1.5);
  c.penchk = random_.pick(0, 2);
}

void ContactMaker::tie_values(Contact& c) {
  c.sldthk = 0, c.soft = 0;
  if (random_.chance(0.3))
    c.sst = -random_.rounded(0.3, 1.5), c.mst = random_.chance(0.3) ? -random_.rounded(0.1, 1) : 0;
  if (random_.chance(0.3)) (c.mpp ? c.parmax : c.maxpar) = random_.rounded(1.0, 1.3);
  if (random_.chance(0.15)) c.ipback = 1;
}

void ContactMaker::optional_values(Contact& c, const ContactKind&) {
  if (random_.chance(0.15)) c.mpp = true, c.mpp_ignore = random_.pick(0, 2);
  if (random_.chance(0.5)) c.soft = random_.pick(0, 2);
  if (random_.chance(0.15)) c.penmax = random_.rounded(0.1, 1);
  if (random_.chance(0.3)) c.thkopt = random_.pick(0, 2), c.shlthk = random_.pick(0, 2);
  if (random_.chance(0.2)) c.snlog = 1;
  if (random_.chance(0.12)) c.sldthk = random_.rounded(0.1, 1);
  if (random_.chance(0.4)) c.ignore = random_.pick(0, 2);
  if (random_.chance(0.1)) c.tcso = 1;
  if (random_.chance(0.1)) c.shledg = random_.pick(1, 2);
  if (random_.chance(0.08)) c.srnde = random_.chance(0.5) ? 1 : 2;
  if (random_.chance(0.08)) c.ignroff = random_.pick(1, 3);
}

}  // namespace gapcheck::reference
