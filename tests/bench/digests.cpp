// Digests of files, models and results: the same for what is the same, and for nothing else.

#include "bench/kit/digests.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "bench/experiments/paper/case_candidate.h"
#include "bench/experiments/paper/options.h"
#include "bench/kit/record/environment.h"
#include "bench/kit/verification.h"
#include "cases/generators/cases.h"
#include "formulations/id.h"
#include "formulations/modelling/modelling.h"
#include "formulations/runtime/digest.h"

namespace desmo::paper::digests_test {
namespace {

using namespace bench;

// The digest of "abc" is that of FIPS 180-2, appendix B.
TEST(Digests, AreSha256) {
  EXPECT_EQ(Digest().add("abc").hex(),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(Digest().add("a").add("").add("bc").hex(), Digest().add("abc").hex());
}

TEST(Digests, TheBinarysIsThatOfItsFile) {
  std::ifstream file("/proc/self/exe", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(binary_digest(), Digest().add(bytes).hex());
  const std::vector<std::string> libraries = shared_libraries();
  EXPECT_TRUE(std::ranges::any_of(
      libraries, [](const std::string& name) { return name.starts_with("libc.so"); }));
}

struct ModelDigest : testing::Test {
  Model m = make_model(truck_suspension(1));
  const std::string original = model_digest(m);
};

TEST_F(ModelDigest, DoesNotFollowTheLastBitsOrNames) {
  for (double& value : m.estimate) value += 1e-15;
  for (Constraint& c : m.constraints)
    for (Derived& constant : c.constants) constant.value = std::nextafter(constant.value, 10);
  m.entities.front().name = "renamed";
  m.groups.front().name = "renamed";
  EXPECT_EQ(model_digest(m), original);
}

TEST_F(ModelDigest, FollowsEverythingThatIsSolved) {
  const auto changed = [&](auto&& change) {
    Model other = m;
    change(other);
    return model_digest(other) != original;
  };
  const auto with_constants =
      std::ranges::find_if(m.constraints, [](const Constraint& c) { return !c.constants.empty(); });
  const auto at = with_constants - m.constraints.begin();
  EXPECT_TRUE(changed([&](Model& o) { o.constraints[at].constants[0].value += 1e-6; }));
  EXPECT_TRUE(changed([&](Model& o) { ++o.constraints[at].kind; }));
  EXPECT_TRUE(changed([&](Model& o) { o.constraints[at].left_out ^= 1; }));
  EXPECT_TRUE(changed(
      [&](Model& o) { std::swap(o.constraints[at].operands[0], o.constraints[at].operands[1]); }));
  EXPECT_TRUE(changed([&](Model& o) { o.constraints.pop_back(); }));
  EXPECT_TRUE(changed([](Model& o) { o.estimate[3] += 1e-6; }));
  EXPECT_TRUE(changed([](Model& o) { o.fixed_values[0] += 1e-6; }));
  EXPECT_TRUE(changed([](Model& o) { o.entities[0].kind = EntityKind::distance; }));
  EXPECT_TRUE(changed([](Model& o) { o.groups[0].entities.pop_back(); }));
  EXPECT_TRUE(changed([](Model& o) { o.length_unit = "1"; }));
  const std::vector<Motion> motions{Polynomial{{1, 2}},
                                    Polynomial{{1, 2.5}},
                                    HarmonicSum{1, {}},
                                    HarmonicSum{1, {{1, 2, 3}}},
                                    make_spline({0, 1, 2}, {0, 1, 0}, SplineEnds::natural),
                                    make_spline({0, 1, 2}, {0, 1, 0}, SplineEnds::clamped)};
  std::set<std::string> found{original};
  for (const Motion& motion : motions) {
    Model other = m;
    other.drivers[0].motion = motion;
    found.insert(model_digest(other));
  }
  EXPECT_EQ(found.size(), motions.size() + 1);
}

TEST(ResultDigests, RoundAsTheReferenceWithinWhatIsAllowed) {
  const double unit = 1e-9;
  EXPECT_EQ(nearest_multiple(1.0, 1.0, unit), 1'000'000'000);
  const double boundary = 12.5 * unit;
  for (const double reference : {boundary - 1e-20, boundary + 1e-20})
    for (const double error : {-0.9e-9, -1e-18, 0.0, 1e-18, 0.9e-9})
      EXPECT_EQ(nearest_multiple(reference + error, reference, unit),
                nearest_multiple(reference, reference, unit))
          << error;
  for (const double error : {-1.1e-9, 1.1e-9, 1e-3})
    EXPECT_NE(nearest_multiple(boundary + error, boundary, unit),
              nearest_multiple(boundary, boundary, unit));
  EXPECT_EQ(nearest_multiple(0.2e-9, -0.2e-9, unit), 0);
  EXPECT_EQ(nearest_multiple(NAN, 1, unit), nearest_multiple(INFINITY, 1, unit));
  EXPECT_NE(nearest_multiple(NAN, 1, unit), nearest_multiple(1, 1, unit));
}

TEST(ResultDigests, AreTheSameForEveryRightFormulationAndNoWrongOne) {
  Options o;
  o.duration = 0.5;
  std::set<std::string> models, results;
  for (const char* id : {"global_automatic_klu", "global_automatic_cholmod",
                         "group_symbolic_lapack", "group_symbolic_inlined"}) {
    CaseCandidate candidate(measured_case(find_case("truck_suspension"), 114, o), {parse_id(id)},
                            o);
    candidate.verify();
    ASSERT_TRUE(candidate.is_verified()) << candidate.message();
    models.insert(candidate.verifying_run().model);
    results.insert(candidate.verifying_run().results);
  }
  EXPECT_EQ(models.size(), 1u);
  EXPECT_EQ(results.size(), 1u);

  const std::vector<ReferenceInstant> reference{{0, {1, 2}, {3, 4}, {5, 6}}};
  const auto digest = [&](std::vector<double> q) {
    ComparingObserver observer(2, Level::acceleration, reference,
                               all_compared(2, Level::acceleration));
    const std::vector<double> qd{3, 4}, qdd{5, 6};
    observer.observe({0, 0, q, qd, qdd});
    return observer.compare().results;
  };
  EXPECT_EQ(digest({1 + 1e-12, 2 - 1e-10}), digest({1, 2}));
  EXPECT_NE(digest({1, 2 + 1e-8}), digest({1, 2}));
  EXPECT_NE(digest({1, NAN}), digest({1, 2}));
  EXPECT_NE(digest({}), digest({1, 2}));
}

}  // namespace
}  // namespace desmo::paper::digests_test
