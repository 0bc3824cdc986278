#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/vector.hpp"

namespace gapcheck::reference {

enum class Kind : std::uint8_t { shell, solid, beam };

struct Node {
  Vector x = Vector::Zero();
  int tc = 0;  ///< TC of *NODE; 7: held in all directions
};

/// Node ids are positions in Scene::nodes plus one. Triangles repeat their last node.
struct Element {
  std::int64_t id = 0, part = 0;
  Kind kind = Kind::shell;
  std::vector<std::int64_t> nodes;  ///< 4: shell; 8: brick; 2: beam
  std::array<double, 4> own{};      ///< *ELEMENT_SHELL_THICKNESS; 0: the section's
};

struct Part {
  std::int64_t id = 0;
  Kind kind = Kind::shell;
  double thickness = 0;  ///< of shells
  double diameter = 0;   ///< of beams
  bool rigid = false;
  double optt = 0, sft = 0;  ///< *PART_CONTACT
};

struct Surface {
  std::int64_t id = 0;
  int type = 2;  ///< SURFATYP
  std::int64_t box = 0;
};

/// A *CONTACT_ with the names of its fields; zero where the field is blank.
struct Contact {
  std::int64_t id = 0;
  std::string name;  ///< after CONTACT_, without option words
  bool mortar = false, mpp = false;
  std::int64_t mpp_ignore = 0;
  double parmax = 0;
  Surface a, b;
  int penchk = 0;
  double sst = 0, mst = 0, sfst = 1, sfmt = 1;
  int soft = 0;
  double maxpar = 0;
  double penmax = 0, sldthk = 0;
  int thkopt = 0, shlthk = 0, snlog = 0;
  int ignore = 0;
  int tcso = 0, shledg = 0, ipback = 0, srnde = 0, ignroff = 0;
};

struct Controls {
  int shlthk = 0, penopt = 1, thkchg = 0, orien = 1;
  double xpene = 4;
  int ssthk = 0, tiedprj = 0;
  double th = 0, th_sf = 0;
  int ignore = 0;
  int shledg = 0;
};

struct Box {
  std::int64_t id = 0;
  Vector low = Vector::Zero(), high = Vector::Zero();
};

/// Members: ids of parts, nodes or shells.
struct Set {
  std::int64_t id = 0;
  std::vector<std::int64_t> members;
};

struct SegmentSet {
  std::int64_t id = 0;
  std::vector<std::array<std::int64_t, 4>> segments;
};

/// A deck as data: the reference takes it from here, the program from its text, so that reading is compared too.
struct Scene {
  std::vector<Node> nodes;
  std::vector<Element> elements;
  std::vector<Part> parts;
  std::vector<Set> part_sets, node_sets, shell_sets;
  std::vector<SegmentSet> segment_sets;
  std::vector<Box> boxes;
  std::vector<Contact> contacts;
  Controls controls;
  bool fixed_columns = false;  ///< contact cards in columns of ten, otherwise separated by commas

  [[nodiscard]] const Part& part(std::int64_t id) const;
  /// The deck; coordinates read back as the same doubles.
  [[nodiscard]] std::string text() const;
};

}  // namespace gapcheck::reference
