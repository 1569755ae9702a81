// Changes of a scene's text, which leave the rest of it as it is.

#include "cases/io/scene_text.h"

#include <gtest/gtest.h>

#include "tests/files/common.h"

namespace desmo::scene_text_test {
namespace {

const std::string id = "group_automatic_klu/guess:hermite5";

TEST(SceneText, GetsAFormulationBehindItsOtherMembers) {
  const std::string text = scene_of(slider_crank, driven);
  const std::string changed = with_formulation(text, id);
  EXPECT_EQ(parse_scene(changed, "s.json", "").formulation, id);
  EXPECT_EQ(changed, text.substr(0, text.size() - 1) + ",\n  \"formulation\": \"" + id + "\"}");
}

TEST(SceneText, ChangesNothingButTheFormulation) {
  const std::string odd =
      "{ \"name\" : \"a \\\"formulation\\\": {\", \"formulation\"\n:\t\"old\" ,"
      "\"motion\":{ \"formulation\": {}, \"a\": [\"formulation\"] }, \"last\": -1.5e3\n}\n";
  EXPECT_EQ(with_formulation(odd, id), replaced(odd, "\n:\t\"old\"", "\n:\t\"" + id + "\""));
  const std::string without = replaced(odd, "\"formulation\"\n:\t\"old\" ,", "");
  EXPECT_EQ(with_formulation(without, id),
            replaced(without, "-1.5e3", "-1.5e3,\n  \"formulation\": \"" + id + "\""));
}

TEST(SceneText, KeepsComments) {
  const std::string noted = "// \"formulation\": \"a\"\n{\"b\": 1 // last\n} // }\n";
  EXPECT_EQ(with_formulation(noted, id),
            replaced(noted, "1 //", "1,\n  \"formulation\": \"" + id + "\" //"));
  const std::string old = replaced(noted, "{", "{\"formulation\": /* old */ \"c\", ");
  EXPECT_EQ(with_formulation(old, id), replaced(old, "\"c\"", '"' + id + '"'));
}

}  // namespace
}  // namespace desmo::scene_text_test
