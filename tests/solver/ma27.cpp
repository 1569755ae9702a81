// Formulations by MA27, with a library of the same interface in its place: what desmo does with the
// interface, and what it says of libraries that do not serve.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

#include "bench/experiments/paper/case_candidate.h"
#include "formulations/algebra/coinhsl.h"
#include "formulations/id.h"
#include "tests/contains.h"
#include "tests/formulated.h"
#include "tests/mechanisms.h"

namespace desmo::ma27_test {
namespace {

/// Formulations by MA27, in a process that finds the library (see tests/CMakeLists.txt).
class Ma27 : public testing::Test {
 protected:
  void SetUp() override {
    const char* const library = std::getenv(coinhsl_variable);
    if (!library || std::string_view(library) != DESMO_MA27_DOUBLE)
      GTEST_SKIP() << "runs where " << coinhsl_variable << " names the library of the tests";
  }
};

constexpr const char* ids[] = {"global_automatic_ma27", "global_symbolic_ma27",
                               "group_automatic_ma27",  "group_symbolic_ma27",
                               "block_automatic_ma27",  "block_symbolic_ma27"};

TEST_F(Ma27, FormulationsAgreeWithTheQuadrupleReference) {
  paper::Options options;
  options.duration = 0.5;
  for (const Case& c : cases())
    for (const char* id : ids) {
      paper::CaseCandidate candidate(paper::measured_case(c, 114, options), {parse_id(id)},
                                     options);
      candidate.verify();
      EXPECT_TRUE(candidate.is_verified()) << candidate.name() << ": " << candidate.message();
      EXPECT_EQ(candidate.verifying_run().errors.instants, 51) << candidate.name();
      EXPECT_LE(candidate.verifying_run().errors.position, 1e-9) << candidate.name();
      EXPECT_LE(candidate.verifying_run().errors.velocity, 1e-8) << candidate.name();
      EXPECT_LE(candidate.verifying_run().errors.acceleration, 1e-7) << candidate.name();
    }
}

TEST_F(Ma27, FormulationsTakeSettings) {
  const Model m = truck_model(1);
  for (const char* id :
       {"global_automatic_ma27/guess:hermite5/jacobian:step", "group_symbolic_ma27/threads:2"}) {
    const auto f = formulated(id, m);
    ASSERT_TRUE(f->assemble(0).ok()) << id;
    for (int i = 1; i <= 20; ++i) EXPECT_TRUE(f->step(0.01 * i).ok()) << id << ", step " << i;
  }
}

TEST_F(Ma27, TheRecordNamesTheLibrary) {
  std::string version;
  for (const auto& [name, its] : library_versions())
    if (name == "ma27") version = its;
  EXPECT_EQ(version, std::filesystem::path(DESMO_MA27_DOUBLE).filename().string() + " 1.2.3");
}

TEST_F(Ma27, IsHereWhereItsLibraryIs) {
  EXPECT_EQ(unavailable_reason("global_automatic_ma27"), "");
  EXPECT_TRUE(faulty_libraries().empty());
  EXPECT_EQ(unavailable_reason("global_automatic_ma57"), "") << "that is not of this build";
}

TEST(CoinHsl, SaysWhatALibraryDoesNotServeFor) {
  const std::pair<const char*, const char*> libraries[] = {
      {DESMO_MA27_INCOMPLETE, "it has no ma27bd_"},
      {DESMO_MA27_DUMMY, "solves nothing"},
      {"/nonexistent/libcoinhsl.so", coinhsl_variable}};
  for (const auto& [file, reason] : libraries) {
    const Absence absence = load_coinhsl(file).absence;
    EXPECT_TRUE(absence.faulty) << file;
    EXPECT_CONTAINS(absence.reason, file);
    EXPECT_CONTAINS(absence.reason, reason);
  }
}

/// The test holds with and without a library on this machine.
TEST(CoinHsl, IsLookedForByItsUsualNames) {
  const CoinHsl usual = load_coinhsl(nullptr);
  EXPECT_EQ(load_coinhsl("").absence.reason, usual.absence.reason);
  if (usual.absence.reason.empty()) {
    EXPECT_FALSE(usual.version.empty());
    return;
  }
  EXPECT_FALSE(usual.absence.faulty) << usual.absence.reason;
  for (const char* name : {"libcoinhsl.so", "libhsl.so", coinhsl_variable})
    EXPECT_CONTAINS(usual.absence.reason, name);
}

}  // namespace
}  // namespace desmo::ma27_test
