// Code for a mechanism that is none of ours: made, found again, right.

#include "formulations/batch/batch_part.h"
#include "formulations/model/partition.h"
#include "formulations/parts/explicit_part.h"
#include "tests/everything.h"
#include "tests/load/loading.h"

namespace desmo::load::own_kernels_test {
namespace {

template <class P>
bool has(const Formulation& f) {
  return std::ranges::any_of(parts_of(f), [](const DefinedPart& part) {
    return dynamic_cast<const P*>(part.solver.get()) != nullptr;
  });
}

struct OwnKernelsTest : Loading {
  /// With code that was made for it, against automatic equations.
  std::unique_ptr<Formulation> compare(const std::string& id) {
    const Settings exact{.tolerance = 1e-13, .coordinates = model_.modelling};
    auto f = made(id, table_, exact);
    const auto reference = make_formulation(find_variant("group_automatic_eigen"), model_, exact);
    const Everything found = everything_of(*f, scene_.grid),
                     expected = everything_of(*reference, scene_.grid);
    for (int i = 0; i < scene_.grid.instants; ++i)
      EXPECT_LT(max_relative_difference(found.all[i], expected.all[i]), 1e-10) << id << ' ' << i;
    return f;
  }
  void take_plates(int copies) {
    take(parse_scene(swinging_plates(copies, one_second), "plates", {}));
  }

  KernelTable table_;
};

TEST_F(OwnKernelsTest, AreNotInTheProgram) {
  for (const char* id : {"group_symbolic_klu", "block_symbolic_inlined"})
    EXPECT_FALSE(is_as_named(*make_formulation(find_variant(id), model_))) << id;
}

TEST_F(OwnKernelsTest, SolveInExplicitOrderWhatAutomaticEquationsSolve) {
  EXPECT_TRUE(has<ExplicitPart>(*compare("group_symbolic_explicit")));
}

TEST_F(OwnKernelsTest, SolveWithEliminationInlinedAndAllAtOnce) {
  compare("group_symbolic_inlined");
  compare("group_symbolic_lapack");
  compare("global_symbolic_klu");
  EXPECT_EQ(compilations(), 1) << "all of them need the same code";
}

TEST_F(OwnKernelsTest, SolveBlockByBlock) { compare("block_symbolic_inlined"); }

TEST_F(OwnKernelsTest, SolveInOtherCoordinates) {
  model_ = make_model(scene_, Modelling::reference);
  compare("group_symbolic_inlined");
}

TEST_F(OwnKernelsTest, SolveTwinsInLanes) {
  take_plates(3);
  EXPECT_TRUE(has<BatchPart>(*compare("group_symbolic_explicit/lanes:4")));
}

TEST_F(OwnKernelsTest, SolveSegmentsOfTheMotionInLanes) {
  const auto f = compare("group_symbolic_explicit/segments:4");
  EXPECT_EQ(stepping_of(*f).runs_without_segments(), 0);
  for (const DefinedPart& part : parts_of(*f))
    if (const auto* solver = dynamic_cast<const ExplicitPart*>(part.solver.get())) {
      EXPECT_NE(table_.find_lane_kernel(solver->kernel().fingerprint, 4), nullptr);
    }
}

TEST_F(OwnKernelsTest, SolveInWiderRegistersWhereThereAreAny) {
  if (!has_lanes(8)) GTEST_SKIP() << unavailable_reason({.lanes = 8});
  take_plates(8);
  EXPECT_TRUE(has<BatchPart>(*compare("group_symbolic_explicit/lanes:8")));
  scene_.grid = time_grid(2, 0.01);
  EXPECT_EQ(stepping_of(*compare("group_symbolic_explicit/segments:8")).runs_without_segments(), 0);
}

TEST_F(OwnKernelsTest, AreNamedByGroupAndCounted) {
  take_plates(3);
  const GenerationOutcome own = load(table_);
  ASSERT_FALSE(own.types.empty());
  int plates = 0;
  for (const TypeUse& t : own.types) {
    EXPECT_TRUE(t.group.starts_with("a/SG-")) << t.group;
    EXPECT_EQ(t.parts, 3) << t.group;
    plates += t.unknowns == 7;
  }
  EXPECT_EQ(plates, 1);
  EXPECT_TRUE(own.compiled);
  EXPECT_GT(own.seconds, own.seconds_compiling);
  EXPECT_GT(own.seconds_compiling, 0);
  EXPECT_EQ(own.folder, cache().string());
  EXPECT_TRUE(own.compiler.starts_with((folder_ / "compiler").string())) << own.compiler;
}

TEST_F(OwnKernelsTest, FollowTheCompilerAndWhatIsAskedOfThem) {
  load();
  use_counted_compiler();
  EXPECT_FALSE(load().compiled);
  EXPECT_EQ(compilations(), 1) << "the same file of the same version";
  fs::rename(folder_ / "compiler", folder_ / "other");
  ::setenv("CXX", (folder_ / "other").c_str(), 1);
  load();
  EXPECT_EQ(compilations(), 2) << "another file";
  load(table_, "group_symbolic_explicit");
  EXPECT_EQ(compilations(), 3) << "explicit orders beside";
}

TEST_F(OwnKernelsTest, DoNotFollowTheDigitsOfAMotion) {
  load();
  scene_.grid.instants -= 1;
  EXPECT_EQ(load().problem, "");
  EXPECT_EQ(compilations(), 1) << "the same code";
}

TEST_F(OwnKernelsTest, AreNeitherMadeNorSoughtWhereTheProgramHasThem) {
  take(library_scene("slider_crank"));
  for (const char* id : {"group_symbolic_explicit/lanes:4", "block_symbolic_inlined"}) {
    const GenerationOutcome own = load(table_, id);
    EXPECT_TRUE(own.types.empty());
    EXPECT_EQ(own.problem, "");
  }
  EXPECT_TRUE(load(table_, "group_automatic_klu").types.empty());
  EXPECT_FALSE(fs::exists(folder_ / "desmo"));
}

}  // namespace
}  // namespace desmo::load::own_kernels_test
