#include "solver/mortar/mortar_pass.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "base/parallel.hpp"

namespace gapcheck::solver {
namespace {

/// Pairs that are checked together.
constexpr std::size_t mortar_pairs_per_block = 64;
double greatest_depth(const model::Contact& contact, std::int64_t ignore) {
  return std::abs(ignore) == 4 ? std::max(0.0, contact.dtstif) : 0;  // MPAR2
}

}  // namespace

MortarPass::MortarPass(const ContactSetting& setting, ContactIndex contact, const contact::ContactSurfaces& surfaces,
                       const std::vector<Vector>& x)
    : contact_(setting.model.contact(contact)),
      x_(x),
      surface_(setting.model, setting.masses, contact_, surfaces, x),
      search_(setting, contact_, surface_, surfaces.two_sided(), surfaces.settings.ignore >= 0,
              greatest_depth(contact_, surfaces.settings.ignore)),
      offsets_(surfaces.settings.ignore, contact_.dprfac, surface_.size()),
      stiffness_(surface_),
      friction_(setting.model, contact_) {}

void MortarPass::find_candidates(double margin, ContactCounters& counters) {
  const std::vector<std::uint64_t> keys = search_.find_pairs(x_, margin);
  counters.candidates += keys.size();
  std::vector<MortarPair> before = std::move(pairs_);
  pairs_.clear();
  pairs_.reserve(keys.size());
  auto old = before.begin();
  // A force ends in the next cycle, not here.
  const auto keep = [&](MortarPair& pair) {
    if (pair.touch) pairs_.push_back(std::move(pair));
  };
  for (const std::uint64_t key : keys) {
    for (; old != before.end() && old->key() < key; ++old) keep(*old);
    MortarPair& pair = pairs_.emplace_back();
    if (old != before.end() && old->key() == key) pair = std::move(*old++);
    pair.tracked = static_cast<std::uint32_t>(key >> 32);
    pair.other = static_cast<std::uint32_t>(key);
  }
  for (; old != before.end(); ++old) keep(*old);
  for (MortarPair& pair : pairs_) pair.wake = 0;
  blocks_.clear();
}

template <class Visit>
void MortarPass::for_each_pair(const Visit& visit) {
  blocks_.resize((pairs_.size() + mortar_pairs_per_block - 1) / mortar_pairs_per_block);
  parallel_for(blocks_.size(), 1, [&](std::size_t begin, std::size_t end) {
    MortarSight sight;
    for (std::size_t b = begin; b < end; ++b) {
      blocks_[b].checked = blocks_[b].asleep = 0;
      blocks_[b].busy.clear();
      const std::size_t last = std::min(pairs_.size(), (b + 1) * mortar_pairs_per_block);
      for (std::size_t i = b * mortar_pairs_per_block; i < last; ++i)
        visit(static_cast<std::uint32_t>(i), blocks_[b], sight);
    }
  });
}

LinkSpring MortarPass::spring_of(const MortarPair& pair, const MortarLaw& law, double area) const {
  const MortarFace &tracked = surface_[pair.tracked], &other = surface_[pair.other];
  LinkSpring spring;
  spring.stiffness = law.stiffness() * area;
  spring.damping = ContactSprings::damping({spring.stiffness, tracked.mass * area, other.mass * area}, contact_.vdc);
  spring.rubs = friction_.any();
  if (spring.rubs) spring.friction = friction_.between(tracked.part, other.part);
  spring.area = area;
  return spring;
}

bool MortarPass::push_pair(MortarPair& pair, const MortarSight& sight, const State& state) const {
  if (!sight.faces || !(pair.deepest > 0)) return false;
  const MortarFace &tracked = surface_[pair.tracked], &other = surface_[pair.other];
  const MortarLaw law = stiffness_.law_of(pair.tracked, pair.other);
  const double h = tracked.half + other.half, release = search_.release_depth(tracked, other);
  pair.forgiven = offsets_.forgiven(pair, state.time, law);
  const MortarPush sum = integrate_pressure(sight, law, h, pair.forgiven, release);
  if (!(sum.push > 0)) return false;
  const Vector friction = pair.touch ? pair.touch->force.friction : Vector(Vector::Zero());
  const bool was_active = pair.touch != nullptr;
  if (!was_active) pair.touch = std::make_unique<MortarTouch>();
  MortarTouch& touch = *pair.touch;
  touch.point = {ContactPoint{tracked.nodes, sum.tracked}, ContactPoint{other.nodes, sum.other}};
  touch.offset = {MortarSurface::offsets(tracked, state.x), MortarSurface::offsets(other, state.x)};
  touch.area = sum.area;
  touch.stored = sum.stored;
  // A stiffness that is allowed now stores energy that nobody paid for.
  if (was_active && touch.law != law)
    pair.lost -= sum.stored - integrate_pressure(sight, touch.law, h, pair.forgiven, release).stored;
  touch.law = law;
  touch.force.normal = -sight.sign * sight.overlap.normal;
  const LinkSpring spring = spring_of(pair, law, sum.area);
  touch.force.set_forces(spring, sum.push / spring.stiffness, touch.velocity(0, state) - touch.velocity(1, state),
                         friction, state.dt);
  return true;
}

void MortarPass::advance_pair(std::uint32_t number, const State& state, double used, Block& block, MortarSight& sight) {
  MortarPair& pair = pairs_[number];
  if (!pair.touch && pair.wake > used) {
    ++block.asleep;
    return;
  }
  ++block.checked;
  pair.work = {};
  pair.lost = 0;
  const double stored = pair.touch ? pair.touch->stored : 0;
  const bool was_active = pair.touch != nullptr;
  // Depth that is no longer forgiven stores energy that nobody paid for: work like that of the nodes, by the same rule.
  const double grown = offsets_.grown(pair, state.time, state.dt);
  const auto add_step_end = [&] {
    pair.touch->add_work(state, pair.work);
    pair.lost -= pair.touch->force.push * grown / 2;
  };
  if (was_active) add_step_end();
  const MortarFace &tracked = surface_[pair.tracked], &other = surface_[pair.other];
  sight_pair(surface_, state.x, pair, search_.release_depth(tracked, other), sight);
  const bool active = push_pair(pair, sight, state);
  if (active)
    add_step_end();
  else
    pair.touch.reset();
  if (pair.released) {
    // What the force took from the parts and neither stores nor has given back.
    const double taken = pair.work.on_tracked + pair.work.on_reference - pair.work.friction - pair.work.damping;
    pair.lost += std::max(0.0, stored + taken - pair.lost - (active ? pair.touch->stored : 0));
  }
  if (was_active || active || pair.released) block.busy.push_back(number);
  if (active) return;
  const double way = search_.way_to_go(tracked, other, state.x);
  pair.wake = used + way;
  // Out of sight: the next meeting may be on the other side.
  if (way > 0) pair.side = 0;
}

void MortarPass::measure_start(const State& state) {
  for_each_pair([&](std::uint32_t number, Block&, MortarSight& sight) {
    MortarPair& pair = pairs_[number];
    sight_pair(surface_, state.x, pair, search_.release_depth(surface_[pair.tracked], surface_[pair.other]), sight);
  });
  offsets_.begin(pairs_, state.time);
  const auto deep = std::count_if(pairs_.begin(), pairs_.end(), [](const MortarPair& pair) { return pair.released; });
  if (deep > 0)
    message_ = fmt::format(
        "pairs of faces deeper in each other than they are held = {}\n     they have no contact there until they "
        "have parted; see PENMAX, or MPAR2 with IGNORE = 4\n",
        deep);
}

double MortarPass::advance_state(State& state, double used, ContactCounters& counters) {
  stiffness_.follow(state);
  if (first_) measure_start(state);
  first_ = false;
  for_each_pair(
      [&](std::uint32_t number, Block& block, MortarSight& sight) { advance_pair(number, state, used, block, sight); });
  offsets_.follow(pairs_);
  for (const Block& block : blocks_) {
    counters.pairs += block.checked;
    counters.asleep += block.asleep;
  }
  return 0;
}

void MortarPass::add_forces(const State& state, Forces& forces, ContactState& result) const {
  for (const Block& block : blocks_)
    for (const std::uint32_t number : block.busy) {
      const MortarPair& pair = pairs_[number];
      const bool from_b = exchanged(pair);
      add_energies(pair.work, from_b, result);
      result.lost += pair.lost;
      result.released += pair.released;
      if (!pair.touch) continue;
      const MortarTouch& touch = *pair.touch;
      ++result.touching;
      const Vector force = touch.force.force();
      for (std::size_t side = 0; side < 2; ++side) {
        const ContactPoint& point = touch.point[side];
        const bool on_b = from_b == (side == 0);
        for (std::size_t i = 0; i < 4; ++i) {
          const Vector push = (side == 0 ? 1 : -1) * point.weights[i] * force;
          const Vector& arm = touch.offset[side][i];
          const std::uint32_t node = point.nodes[i].value;
          forces.force[node] += push;
          if (arm != Vector::Zero()) forces.moment[node] += arm.cross(push);
          if (result.single_surface) continue;
          (on_b ? result.force_b : result.force_a) += push;
          (on_b ? result.moment_b : result.moment_a) += (state.x[node] + arm).cross(push);
        }
      }
    }
}

void MortarPass::continue_from(InterfacePass& before, const State& state, ContactState& result) {
  auto* const old = dynamic_cast<MortarPass*>(&before);
  if (old == nullptr) return before.deactivate(state, result);
  first_ = old->first_;
  offsets_.continue_from(old->offsets_);
  // Nodes of the face, and whether it is one at a free edge.
  const auto name = [](const MortarFace& face) {
    model::SegmentNodes nodes = face.nodes;
    std::sort(nodes.begin(), nodes.end());
    return std::pair(nodes, face.rim);
  };
  std::map<std::pair<model::SegmentNodes, bool>, std::uint32_t> numbers;
  for (std::uint32_t i = 0; i < surface_.size(); ++i) numbers.emplace(name(surface_[i]), i);
  std::vector<std::uint32_t> now(old->surface_.size(), no_position);
  for (std::uint32_t i = 0; i < now.size(); ++i)
    if (const auto found = numbers.find(name(old->surface_[i])); found != numbers.end()) {
      now[i] = found->second;
      offsets_.take(now[i], old->offsets_, i);
    }
  pairs_.clear();
  for (MortarPair& was : old->pairs_) {
    if (now[was.tracked] == no_position || now[was.other] == no_position) continue;
    const std::uint32_t tracked = now[was.tracked], other = now[was.other];
    MortarPair& pair = pairs_.emplace_back(std::move(was));
    pair.tracked = tracked;
    pair.other = other;
    pair.wake = 0;
  }
  std::sort(pairs_.begin(), pairs_.end(), [](const MortarPair& a, const MortarPair& b) { return a.key() < b.key(); });
  old->deactivate(state, result);  // of ended contacts
}

void MortarPass::deactivate(const State& state, ContactState& result) {
  for (MortarPair& pair : pairs_) {
    if (pair.touch) {
      LinkWork work;
      pair.touch->add_work(state, work);
      add_energies(work, exchanged(pair), result);
      result.lost += pair.touch->stored;
    }
    pair.touch.reset();
    pair.side = 0;
    pair.wake = 0;
  }
  blocks_.clear();
  first_ = true;
}

double MortarPass::stored() const {
  double sum = 0;
  for (const MortarPair& pair : pairs_)
    if (pair.touch) sum += pair.touch->stored;
  return sum;
}

std::vector<ContactNode> MortarPass::nodes() const {
  std::vector<ContactNode> all;
  for (const MortarPair& pair : pairs_) {
    if (!pair.touch) continue;
    const MortarTouch& touch = *pair.touch;
    const Vector force = touch.force.force();
    for (std::size_t side = 0; side < 2; ++side)
      for (std::size_t i = 0; i < 4; ++i) {
        const double weight = touch.point[side].weights[i];
        if (!(weight > 0)) continue;
        ContactNode& node = all.emplace_back();
        node.node = touch.point[side].nodes[i];
        node.segment = touch.point[1 - side].nodes;
        node.force = (side == 0 ? weight : -weight) * force;
        node.penetration = pair.deepest;
        node.forgiven = pair.forgiven;
        node.pressure = touch.area > 0 ? (touch.force.push + touch.force.damping) / touch.area : 0;
      }
  }
  return all;
}

void MortarPass::add_links(std::vector<ContactLink>& links) const {
  for (const MortarPair& pair : pairs_)
    if (pair.touch)
      links.push_back({pair.touch->point[0], pair.touch->point[1], exchanged(pair), pair.touch->force.force()});
}

}  // namespace gapcheck::solver
