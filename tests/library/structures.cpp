// Structural groups of the library's mechanisms against those found by hand.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "cases/io/files.h"
#include "cases/library/library.h"
#include "formulations/modelling/modelling.h"

namespace desmo::library_structures_test {
namespace {

/// A structural group known beforehand: its bodies, and the groups (in the list) it hangs on.
struct KnownGroup {
  std::vector<std::string> bodies;
  std::vector<int> after;
};

struct KnownStructure {
  int degrees_of_freedom;
  std::vector<KnownGroup> groups;
};

const std::map<std::string, KnownStructure, std::less<>>& known_structures() {
  static const std::map<std::string, KnownStructure, std::less<>> known{
      {"slider_crank", {1, {{{"crank"}, {}}, {{"rod", "slider"}, {0}}}}},
      // The driver acts between two bodies that both move: nothing is determined before the rest.
      {"inverted_slider_crank", {1, {{{"cylinder", "rod", "boom"}, {}}}}},
      {"whitworth", {1, {{{"crank"}, {}}, {{"lever"}, {0}}, {{"link", "ram"}, {1}}}}},
      {"watt_six_bar",
       {1, {{{"crank"}, {}}, {{"coupler", "rocker"}, {0}}, {{"link5", "link6"}, {1}}}}},
      // A triad: three links and what they carry (class III after Assur and Artobolevsky).
      {"stephenson_six_bar",
       {1, {{{"crank"}, {}}, {{"link", "coupler", "rocker1", "rocker2"}, {0}}}}},
      {"jansen_leg",
       {1,
        {{{"crank"}, {}},
         {{"rod_j", "upper"}, {0}},
         {{"rod_k", "rod_c"}, {0}},
         {{"rod_f", "foot"}, {1, 2}}}}},
      {"andrews",
       {1, {{{"K1"}, {}}, {{"K2", "K3"}, {0}}, {{"K4", "K5"}, {1}}, {{"K6", "K7"}, {1}}}}},
      {"rssr", {1, {{{"crank"}, {}}, {{"coupler", "rocker"}, {0}}}}},
      {"stewart",
       {6,
        {{{"platform", "lower1", "upper1", "lower2", "upper2", "lower3", "upper3", "lower4",
           "upper4", "lower5", "upper5", "lower6", "upper6"},
          {}}}}},
      {"delta",
       {3,
        {{{"arm1"}, {}},
         {{"arm2"}, {}},
         {{"arm3"}, {}},
         {{"rod1a", "rod1b", "rod2a", "rod2b", "rod3a", "rod3b", "platform"}, {0, 1, 2}}}}},
      {"double_wishbone", {2, {{{"rack"}, {}}, {{"lower", "upper", "upright", "tie_rod"}, {0}}}}},
      {"macpherson", {2, {{{"rack"}, {}}, {{"arm", "upright", "rod", "tie_rod"}, {0}}}}},
      {"truck_axle",
       {2,
        {{{"2", "3", "4", "5"}, {}},
         {{"6", "8"}, {0}},
         {{"7", "9"}, {0}},
         {{"10", "11"}, {0}},
         {{"12", "13"}, {0}}}}}};
  return known;
}

void expect_known_structure(const LibraryMechanism& l) {
  const Model m = make_model(library_scene(l.name));
  ASSERT_TRUE(known_structures().contains(l.name));
  const KnownStructure& known = known_structures().find(l.name)->second;
  EXPECT_EQ(m.degrees_of_freedom(), known.degrees_of_freedom);
  EXPECT_EQ(m.structural_groups(), static_cast<int>(known.groups.size()));

  std::vector<std::ptrdiff_t> position;  // of each known group in the solution order
  for (const KnownGroup& g : known.groups) {
    const auto it = std::ranges::find_if(m.groups, [&](const Group& found) {
      return !found.constant && std::ranges::is_permutation(found.bodies, g.bodies);
    });
    ASSERT_NE(it, m.groups.end()) << "no group of " << testing::PrintToString(g.bodies);
    position.push_back(it - m.groups.begin());
    for (const int before : g.after)
      EXPECT_LT(position[before], position.back()) << testing::PrintToString(g.bodies);
  }
}

TEST(LibraryStructures, AreThoseFoundByHand) {
  for (const LibraryMechanism& l : library()) {
    SCOPED_TRACE(l.name);
    expect_known_structure(l);
  }
}

}  // namespace
}  // namespace desmo::library_structures_test
