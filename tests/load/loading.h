// The fixture of tests that compile and load code: a cache folder and a compiler that counts calls.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cases/generators/cases.h"
#include "cases/io/files.h"
#include "formulations/equations/kernel_table.h"
#include "formulations/id.h"
#include "formulations/modelling/modelling.h"
#include "formulations/motion/internals.h"
#include "formulations/runtime/own_kernels.h"
#include "tests/own_mechanism.h"
#include "tests/started.h"

namespace desmo::load {

namespace fs = std::filesystem;

class Loading : public InFolder {
 protected:
  Loading() {
    ::setenv("XDG_CACHE_HOME", folder_.c_str(), 1);
    use_counted_compiler();
  }
  ~Loading() override {
    ::unsetenv("CXX");
    ::unsetenv("XDG_CACHE_HOME");
  }

  /// Sets CXX to a script that runs these shell commands to compile.
  void use_compiler(const std::string& commands) {
    const std::string compiler = write(
        "compiler", "#!/bin/sh\n[ \"$1\" = --version ] && exec " DESMO_COMPILER " --version\n" +
                        commands + "\n");
    fs::permissions(compiler, fs::perms::owner_all);
    ::setenv("CXX", compiler.c_str(), 1);
  }
  void use_counted_compiler() {
    use_compiler("echo compiled >>'" + file("count") + "'\nexec " DESMO_COMPILER " \"$@\"");
  }
  int compilations() const {
    return static_cast<int>(std::ranges::count(text_of(file("count")), '\n'));
  }

  fs::path cache() const { return folder_ / "desmo" / "kernels"; }
  /// Returns the files of the cache whose names have this ending, sorted.
  std::vector<fs::path> cached(const std::string& end) const {
    std::vector<fs::path> result;
    for (const fs::directory_entry& file : fs::directory_iterator(cache()))
      if (file.path().string().ends_with(end)) result.push_back(file.path());
    std::ranges::sort(result);
    return result;
  }

  /// Takes another mechanism, with its motion.
  void take(Scene scene) {
    scene_ = std::move(scene);
    model_ = make_model(scene_);
  }
  /// Takes a scene of tests/load/scenes.
  void take(const std::string& name) {
    take(read_scene(fs::path(DESMO_SOURCE_DIR) / "tests/load/scenes" / (name + ".scene.json")));
  }

  GenerationOutcome load(KernelTable& table, const std::string& id = "group_symbolic_inlined") {
    const Configuration c = parse_id(id);
    return add_generated_code(table, *c.variant, c.settings, model_, scene_.grid, limit_);
  }
  GenerationOutcome load() {
    KernelTable table;
    return load(table);
  }
  /// Makes the formulation of an id with generated code where it needs some, and no part stands in
  /// for another. base: settings that the id does not name.
  std::unique_ptr<Formulation> made(const std::string& id, KernelTable& table,
                                    const Settings& base = {}) {
    const Configuration c = parse_id(id, base);
    EXPECT_EQ(load(table, id).problem, "") << id;
    auto f = make_formulation(*c.variant, model_, c.settings, table);
    EXPECT_TRUE(is_as_named(*f)) << id;
    return f;
  }
  /// Expects that there is no code, why, and that the mechanism is solved without.
  void expect_problem(const std::string& why) {
    KernelTable table;
    const GenerationOutcome own = load(table);
    EXPECT_CONTAINS(own.problem, why);
    EXPECT_FALSE(own.types.empty());
    EXPECT_EQ(compilations(), 0);
    const auto f = make_formulation(find_variant("group_symbolic_inlined"), model_, {}, table);
    EXPECT_FALSE(is_as_named(*f));
    EXPECT_TRUE(f->assemble(0).ok());
  }
  static bool is_as_named(const Formulation& f) {
    return std::ranges::all_of(parts_of(f), &DefinedPart::as_named);
  }

  Scene scene_ = parse_scene(swinging_plates(1, one_second), "plates", {});
  Model model_ = make_model(scene_);
  std::chrono::milliseconds limit_ = std::chrono::minutes(3);  // enough on a busy machine
};

}  // namespace desmo::load
