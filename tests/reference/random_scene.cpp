#include "reference/random_scene.hpp"

#include <algorithm>

#include "reference/random_bodies.hpp"
#include "reference/random_contacts.hpp"

namespace gapcheck::reference {
namespace {

void draw_controls(Random& random, Controls& c) {
  c.ssthk = random.chance(0.6) ? 1 : 0;
  c.shlthk = random.pick(0, 2);
  c.penopt = random.pick(1, 5);
  c.thkchg = random.pick(0, 2);
  c.orien = random.chance(0.3) ? random.pick(0, 2) : 1;
  if (random.chance(0.3)) c.xpene = random.rounded(0.1, 2);
  if (random.chance(0.08)) c.th = random.rounded(0.2, 1.2);
  if (random.chance(0.1)) c.th_sf = random.rounded(0.6, 1.4);
  if (random.chance(0.25)) c.ignore = random.pick(1, 2);
  if (random.chance(0.2)) c.tiedprj = 1;
  if (random.chance(0.2)) c.shledg = 1;
}

}  // namespace

Scene random_scene(std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  scene.fixed_columns = random.chance(0.5);
  draw_controls(random, scene.controls);
  BodyMaker(random, scene).all();
  ContactMaker(random, scene).all();
  return scene;
}

}  // namespace gapcheck::reference
