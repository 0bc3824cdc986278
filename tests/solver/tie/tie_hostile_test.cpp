// Ties of decks that nobody would want to have written: they end in numbers or in words.
#include <gtest/gtest.h>

#include "solver/tie/tie_scene.hpp"

namespace gapcheck::solver::tie_hostile_test {
namespace {

const std::vector<std::string> forms{"TIED_NODES_TO_SURFACE",
                                     "TIED_SHELL_EDGE_TO_SURFACE",
                                     "TIED_NODES_TO_SURFACE_OFFSET",
                                     "TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET",
                                     "TIED_SHELL_EDGE_TO_SURFACE_CONSTRAINED_OFFSET",
                                     "TIEBREAK_NODES_TO_SURFACE"};

/// Nodes of a plate tied to segments as given; the end of the run has numbers, or the run says why there is none. True
/// if it came to its end.
bool expect_orderly(const std::string& form, const std::string& segments, const std::string& card_3,
                    const std::string& more = "") {
  const TieDeck::Grid base{1, {0, 0, 0}, {1, 1, 0.1}, 1, 1, 0}, upper{2, {0.2, 0.2, 0}, {0.6, 0.6, 0.1}, 1, 1, 0};
  TieDeck deck;
  deck.add(base).add(upper).load({2001}, 3, 1e-4);
  deck.also("*SET_SEGMENT\n7\n" + segments + "*SET_NODE_LIST\n8\n2001,2002,2003,2004\n*CONTACT_" + form +
            "\n8,7,4,0\n0.\n" + card_3 + "\n" + (form.starts_with("TIEBREAK") ? "1e-6,1e-6\n" : "") + more);
  RunSettings settings;
  settings.cycles = 50;
  RunScene scene(deck.text(100), settings);
  const auto end = scene.try_to_go();
  if (!end || *end == RunEnd::failed) {
    EXPECT_FALSE(scene.message().empty()) << form << " " << segments;
    return false;
  }
  for (const Vector& x : scene.state().x) EXPECT_TRUE(std::isfinite(x.sum())) << form << " " << segments << card_3;
  return true;
}

TEST(TieHostile, SegmentsWithoutArea) {
  for (const std::string& form : forms)
    for (const char* segments : {"1001,1001,1001,1001\n", "1001,1002,1002,1001\n", "1001,1002,1001,1002\n",
                                 "1001,1002,1004,1003\n", "1001,1002,1004,1004\n", "1001,1003,1002,1004\n",
                                 "1001,1002,2001,2001\n", "2001,2002,2004,2003\n", "0,0,0,0\n"}) {
      const bool ended = expect_orderly(form, segments, "1.,1.,-1.,-1.");
      const bool sound = std::string_view(segments) == "1001,1002,1004,1003\n";
      EXPECT_TRUE(ended || !sound) << form;
    }
}

TEST(TieHostile, NumbersOfCard3) {
  for (const std::string& form : forms)
    for (const char* card : {"1e300,1e300,-1.,-1.", "1e-300,1e-300,-1.,-1.", "0.,0.,-1e300,-1e300", "nan,nan,-1.,-1.",
                             "1.,1.,-1e-300,0.", "-1.,-1.,-1.,-1."})
      expect_orderly(form, "1001,1002,1004,1003\n", card);
}

TEST(TieHostile, MassesAndSides) {
  for (const std::string& form : forms) {
    expect_orderly(form, "1001,1002,1004,1003\n", "1.,1.,-1.,-1.", "*ELEMENT_MASS\n1,2001,1e300\n2,1001,1e-300\n");
    for (const char* mass : {"1e-310", "1e-300"})
      expect_orderly(form, "5001,5002,5004,5003\n", "1.,1.,-1.,-1.",
                     fmt::format("*NODE\n5001,0.,0.,0.05\n5002,1.,0.,0.05\n5003,0.,1.,0.05\n5004,1.,1.,0.05\n"
                                 "*ELEMENT_MASS\n1,5001,{0}\n2,5002,{0}\n3,5003,{0}\n4,5004,{0}\n",
                                 mass));
    expect_orderly(form, "", "1.,1.,-1.,-1.");
    expect_orderly(form, "1001,1002,1004,1003\n", "1.,1.,-1.,-1.",
                   "*BOUNDARY_SPC_NODE\n2001,0,1,1,1,1,1,1\n1001,0,1,1,1,1,1,1\n1002,0,1,1,1,1,1,1\n"
                   "1003,0,1,1,1,1,1,1\n1004,0,1,1,1,1,1,1\n");
  }
}

}  // namespace
}  // namespace gapcheck::solver::tie_hostile_test
