// desmo_bench --scene: a scene of the user's own in the tables and the record.

#include <nlohmann/json.hpp>

#include "tests/started.h"

namespace desmo::bench::own_scene_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

class OwnScene : public InFolder {
 protected:
  OwnScene() { fs::create_directory(folder_ / "cache"); }

  /// environment: settings of variables, for the shell.
  Ended measure(const fs::path& scene, const std::string& flags,
                const std::string& environment = "") const {
    return run("XDG_CACHE_HOME=" + file("cache") + " " + environment +
               " " DESMO_BENCH " --repetitions=2 --record=" + record() + " --scene '" +
               scene.string() + "' " + flags);
  }
  /// Returns what the record says of a formulation; null where it says nothing.
  Json candidate(const std::string& id) const {
    const Json record_of_run = Json::parse(text_of(record()));
    for (const Json& candidate : record_of_run["paper"]["candidates"])
      if (candidate["id"] == id) return candidate;
    return {};
  }
  std::string record() const { return file("record.json"); }

  const fs::path slider_crank_ = DESMO_SOURCE_DIR "/tests/consumer/slider_crank.scene.json";
};

// It has a type of groups that the program was not built with.
TEST_F(OwnScene, IsVerifiedAndTimedInEveryFormulation) {
  const Ended ended =
      measure(slider_crank_, "'--filter=_(klu|inlined|explicit)(/check:proof)?$|lanes:4'");
  ASSERT_EQ(ended.code, 0) << ended.text;
  for (const char* id :
       {"global_automatic_klu", "global_symbolic_klu", "group_symbolic_klu",
        "group_symbolic_inlined", "block_symbolic_explicit", "group_symbolic_explicit/check:proof",
        "group_symbolic_explicit/guess:adams8/lanes:4/tolerance:1e-10"}) {
    const Json found = candidate(id);
    ASSERT_FALSE(found.is_null()) << id;
    EXPECT_EQ(found["case"], "slider_crank");
    EXPECT_EQ(found["status"], "ok") << id << ": " << found.value("message", "");
    EXPECT_LE(found["verification"]["acceleration"], 1e-7) << id;
    EXPECT_EQ(found["time"]["seconds"].size(), 2u) << id;
  }
  const Ended report = run(DESMO_REPORT " tables --all " + record());
  EXPECT_EQ(report.code, 0) << report.text;
  for (const char* shown : {"slider_crank", "group_symbolic_inlined"})
    EXPECT_CONTAINS(report.text, shown) << shown << report.text;
}

TEST_F(OwnScene, MayBeginAtAnyTime) {
  Json scene = Json::parse(text_of(slider_crank_));
  const double end = scene["time"]["end"];
  scene["time"]["start"] = 2;
  scene["time"]["end"] = 2 + end;
  const Ended ended =
      measure(write("later.json", scene.dump()), "'--filter=global_automatic_eigen$'");
  ASSERT_EQ(ended.code, 0) << ended.text;
  EXPECT_DOUBLE_EQ(Json::parse(text_of(record()))["record"]["settings"]["duration_seconds"], end);
  const Ended report = run(DESMO_REPORT " tables " + record());
  EXPECT_EQ(report.code, 0) << report.text;
}

TEST_F(OwnScene, IsNotRunWhereThereIsNoCodeForIt) {
  const Ended ended =
      measure(slider_crank_, "'--filter=group_.*_(eigen|inlined)$'", "CXX=/nonexistent/compiler");
  EXPECT_EQ(ended.code, 0) << ended.text;
  EXPECT_EQ(candidate("group_automatic_eigen")["status"], "ok");
  for (const char* id : {"group_symbolic_eigen", "group_symbolic_inlined"}) {
    EXPECT_EQ(candidate(id)["status"], "not_run") << id;
    EXPECT_CONTAINS(candidate(id).value("message", ""), "CXX=/nonexistent/compiler")
        << candidate(id);
  }
}

TEST_F(OwnScene, HasNoTimeWhereItIsWrong) {
  const std::string id = "group_automatic_eigen/iterations:1";
  const Ended ended =
      measure(slider_crank_, "--step=0.1 --formulation=" + id + " '--filter=" + id + "$'");
  EXPECT_EQ(ended.code, 1) << ended.text;
  EXPECT_EQ(candidate(id)["status"], "failed");
  EXPECT_CONTAINS(ended.text, "differs from the reference");
}

TEST_F(OwnScene, SaysWhatIsWrongWithItsFile) {
  Json scene = Json::parse(text_of(slider_crank_));
  const Json mechanism = scene["mechanism"];
  scene["motion"] = {{"phi", 1}};
  const auto says = [&](const fs::path& name, int code, const std::string& what) {
    const Ended ended = measure(name, "");
    EXPECT_EQ(ended.code, code) << ended.text;
    EXPECT_CONTAINS(ended.text, "desmo_bench: " + name.string() + ": " + what);
    EXPECT_FALSE(fs::exists(record()));
  };
  says(folder_ / "nowhere.json", 66, "there is no such file");
  says(folder_, 66, "is a directory");
  says(write("cut.json", "{\"format\""), 65, "");
  says(write("motion.json", scene.dump()), 65, "/motion");
  says(write("mechanism.json", mechanism.dump()), 65, "/format");

  const fs::path named = write("four_bar.scene.json", text_of(slider_crank_));
  EXPECT_EQ(measure(named, "").code, 64);
  EXPECT_EQ(measure(slider_crank_, "--scene " + slider_crank_.string()).code, 64);
}

// Elsewhere names would end in file names and patterns.
TEST_F(OwnScene, HasANameWithoutBlanks) {
  const Ended listed = measure(write("my first.crank.json", text_of(slider_crank_)),
                               "--benchmark_list_tests --filter group_automatic_klu");
  EXPECT_EQ(listed.code, 0);
  EXPECT_TRUE(listed.text.starts_with("my_first_crank/")) << listed.text;
}

}  // namespace
}  // namespace desmo::bench::own_scene_test
