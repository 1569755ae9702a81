// desmo_bench: options, verification, requests, and what it does when a formulation is wrong.

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numeric>
#include <set>
#include <string>

#include "bench/suite/binary.h"
#include "bench/suite/cell.h"
#include "bench/suite/cpu_clock.h"
#include "bench/suite/model_digest.h"
#include "bench/suite/options.h"
#include "bench/suite/request.h"
#include "bench/suite/result_digest.h"
#include "bench/suite/structure.h"
#include "bench/suite/verification.h"
#include "cases/files.h"
#include "cases/library.h"
#include "formulations/digest.h"
#include "formulations/modelling/model.h"

namespace desmo::suite {
namespace {

Options parse(std::vector<std::string> texts, std::vector<std::string>* rest = nullptr) {
  std::vector<char*> arguments;
  for (std::string& t : texts) arguments.push_back(t.data());
  const Options o = take_options(arguments);
  if (rest) rest->assign(arguments.begin(), arguments.end());
  return o;
}

TEST(BenchOptions, TakeTheirOwnAndLeaveTheRest) {
  std::vector<std::string> rest;
  const Options o = parse({"x", "--step=0.02", "--benchmark_filter=a", "--duration", "3",
                           "--record=out.json", "--dense-limit=9", "--slow-limit=8"},
                          &rest);
  EXPECT_EQ(o.step, 0.02);
  EXPECT_EQ(o.duration, 3);
  EXPECT_EQ(o.dense_limit, 9);
  EXPECT_EQ(o.slow_limit, 8);
  EXPECT_EQ(o.record, "out.json");
  EXPECT_EQ(rest, (std::vector<std::string>{"x", "--benchmark_filter=a"}));
}

TEST(BenchOptions, RefuseWhatIsNotAPositiveNumber) {
  for (const char* bad : {"--step=0", "--step=-1", "--step=nan", "--step=inf", "--step=1x",
                          "--step=", "--dense-limit=2.5", "--duration=1e999"})
    EXPECT_THROW(parse({"x", bad}), std::invalid_argument) << bad;
  EXPECT_THROW(parse({"x", "--record"}), std::invalid_argument);
}

struct Verification : testing::Test {
  std::vector<ReferenceInstant> reference{{0, {1, 2}, {3, 4}, {5, 6}}, {1, {1, 2}, {3, 4}, {5, 6}}};
  VerifyingSink sink{reference};

  void accept(int index, double time, std::vector<double> q) {
    const std::vector<double> qd{3, 4}, qdd{5, 6};
    sink.accept({index, time, q, qd, qdd});
  }
};

TEST_F(Verification, AcceptsWhatAgrees) {
  accept(0, 0, {1, 2});
  accept(1, 0.5, {7, 7});  // the reference has nothing to say here
  accept(2, 1, {1, 2 + 1e-10});
  EXPECT_EQ(complaint(sink.errors(), 2), "");
  EXPECT_NEAR(sink.errors().position, 1e-10, 1e-15);
}

TEST_F(Verification, RefusesWhatDiffers) {
  accept(0, 0, {1, 2});
  accept(1, 1, {1, 2 + 1e-8});
  EXPECT_NE(complaint(sink.errors(), 2), "");
}

TEST_F(Verification, RefusesWhatIsNotANumber) {
  accept(0, 0, {1, NAN});
  accept(1, 1, {1, 2});
  EXPECT_NE(complaint(sink.errors(), 2), "");
}

TEST_F(Verification, RefusesWhatIsMissing) {
  accept(0, 0, {});
  accept(1, 1, {1, 2});
  EXPECT_NE(complaint(sink.errors(), 2), "");
}

TEST_F(Verification, RefusesInstantsThatWereNeverSeen) {
  accept(0, 0, {1, 2});
  EXPECT_NE(complaint(sink.errors(), 2), "");
}

// Of FIPS 180-2, appendix B.
TEST(Digests, AreSha256) {
  EXPECT_EQ(Digest().add("abc").hex(),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(Digest().add("a").add("").add("bc").hex(), Digest().add("abc").hex());
}

TEST(Digests, TheBinarysIsThatOfItsFile) {
  std::ifstream file("/proc/self/exe", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(binary_digest(), Digest().add(bytes).hex());
  const Link link = this_link();
  EXPECT_EQ(link.type, "dynamic");
  EXPECT_TRUE(std::ranges::any_of(
      link.libraries, [](const std::string& name) { return name.starts_with("libc.so"); }));
}

struct ModelDigest : testing::Test {
  Mechanism m = make_mechanism(truck_suspension(1));
  const std::string original = model_digest(m);
};

TEST_F(ModelDigest, IsThatOfTheSameModelMadeAgain) {
  EXPECT_EQ(model_digest(make_mechanism(truck_suspension(1))), original);
  EXPECT_NE(model_digest(make_mechanism(truck_suspension(2))), original);
  EXPECT_NE(model_digest(make_mechanism(four_bar(2))), original);
}

TEST_F(ModelDigest, DoesNotFollowTheLastBitsOrNames) {
  for (double& value : m.estimate) value += 1e-15;
  for (Constraint& c : m.constraints)
    for (double& value : c.constants) value = std::nextafter(value, 10);
  m.entities.front().name = "renamed";
  m.groups.front().name = "renamed";
  EXPECT_EQ(model_digest(m), original);
}

TEST_F(ModelDigest, FollowsEverythingThatIsSolved) {
  const auto changed = [&](auto&& change) {
    Mechanism other = m;
    change(other);
    return model_digest(other) != original;
  };
  const auto with_constants =
      std::ranges::find_if(m.constraints, [](const Constraint& c) { return !c.constants.empty(); });
  const auto at = with_constants - m.constraints.begin();
  EXPECT_TRUE(changed([&](Mechanism& o) { o.constraints[at].constants[0] += 1e-6; }));
  EXPECT_TRUE(changed([&](Mechanism& o) { ++o.constraints[at].kind; }));
  EXPECT_TRUE(changed([&](Mechanism& o) { o.constraints[at].left_out ^= 1; }));
  EXPECT_TRUE(changed([&](Mechanism& o) {
    std::swap(o.constraints[at].operands[0], o.constraints[at].operands[1]);
  }));
  EXPECT_TRUE(changed([&](Mechanism& o) { o.constraints.pop_back(); }));
  EXPECT_TRUE(changed([](Mechanism& o) { o.estimate[3] += 1e-6; }));
  EXPECT_TRUE(changed([](Mechanism& o) { o.fixed_values[0] += 1e-6; }));
  EXPECT_TRUE(changed([](Mechanism& o) { o.entities[0].kind = EntityKind::distance; }));
  EXPECT_TRUE(changed([](Mechanism& o) { o.groups[0].entities.pop_back(); }));
  EXPECT_TRUE(changed([](Mechanism& o) { o.length_unit = "1"; }));
  const std::vector<Motion> motions{Polynomial{{1, 2}},
                                    Polynomial{{1, 2.5}},
                                    HarmonicSum{1, {}},
                                    HarmonicSum{1, {{1, 2, 3}}},
                                    make_spline({0, 1, 2}, {0, 1, 0}, SplineEnds::natural),
                                    make_spline({0, 1, 2}, {0, 1, 0}, SplineEnds::clamped)};
  std::set<std::string> found{original};
  for (const Motion& motion : motions) {
    Mechanism other = m;
    other.drivers[0].motion = motion;
    found.insert(model_digest(other));
  }
  EXPECT_EQ(found.size(), motions.size() + 1);
}

TEST(ResultDigests, RoundAsTheReferenceWithinWhatIsAllowed) {
  const double unit = 1e-9;
  EXPECT_EQ(rounded(1.0, 1.0, unit), 1'000'000'000);
  const double boundary = 12.5 * unit;
  for (const double reference : {boundary - 1e-20, boundary + 1e-20})
    for (const double error : {-0.9e-9, -1e-18, 0.0, 1e-18, 0.9e-9})
      EXPECT_EQ(rounded(reference + error, reference, unit), rounded(reference, reference, unit))
          << error;
  for (const double error : {-1.1e-9, 1.1e-9, 1e-3})
    EXPECT_NE(rounded(boundary + error, boundary, unit), rounded(boundary, boundary, unit));
  EXPECT_EQ(rounded(0.2e-9, -0.2e-9, unit), 0);
  EXPECT_EQ(rounded(NAN, 1, unit), rounded(INFINITY, 1, unit));
  EXPECT_NE(rounded(NAN, 1, unit), rounded(1, 1, unit));
}

TEST(ResultDigests, AreTheSameForEveryRightFormulationAndNoWrongOne) {
  Options o;
  o.duration = 0.5;
  ReferenceCache references;
  std::set<std::string> models, results;
  for (const char* id : {"global_automatic_klu", "global_automatic_cholmod",
                         "group_symbolic_lapack", "group_symbolic_inlined"}) {
    Cell cell(find_case("truck_suspension"), 114, find_variant(id), o);
    cell.verify(references);
    ASSERT_EQ(cell.state, Cell::State::verified) << cell.message;
    models.insert(cell.model);
    results.insert(cell.results);
  }
  EXPECT_EQ(models.size(), 1u);
  EXPECT_EQ(results.size(), 1u);

  const std::vector<ReferenceInstant> reference{{0, {1, 2}, {3, 4}, {5, 6}}};
  const auto digest = [&](std::vector<double> q) {
    VerifyingSink sink(reference);
    const std::vector<double> qd{3, 4}, qdd{5, 6};
    sink.accept({0, 0, q, qd, qdd});
    return sink.results();
  };
  EXPECT_EQ(digest({1 + 1e-12, 2 - 1e-10}), digest({1, 2}));
  EXPECT_NE(digest({1, 2 + 1e-8}), digest({1, 2}));
  EXPECT_NE(digest({1, NAN}), digest({1, 2}));
  EXPECT_NE(digest({}), digest({1, 2}));
}

void spend(double seconds) {
  for (const double start = cpu_now(); cpu_now() - start < seconds;) {
  }
}

TEST(Segments, KeepTheLeastTimeOfEach) {
  Segments segments(500);  // 25 of 20 instants
  for (const int disturbed : {70, 310, -1}) {
    segments.begin();
    spend(1e-3);  // assembly
    for (int i = 0; i < 500; ++i) {
      spend(2e-6);
      if (i == disturbed) spend(0.05);
      segments.passed(i < 20 ? 7 : 1);
    }
  }
  ASSERT_EQ(segments.count(), 25u);
  ASSERT_EQ(segments.samples().size(), 3u);
  for (const std::vector<double>& sample : segments.samples()) EXPECT_EQ(sample.size(), 25u);
  EXPECT_EQ(segments.updates()[0], 140);
  EXPECT_EQ(segments.updates()[24], 20);
  ASSERT_EQ(segments.least().size(), 25u);
  EXPECT_GE(segments.least()[0], 1e-3);
  for (const double seconds : segments.least()) {
    EXPECT_GE(seconds, 4e-5);
    EXPECT_LT(seconds, 0.05);
  }
}

TEST(Segments, AreFewerWhenThereAreFewInstants) {
  for (const auto& [instants, count] :
       {std::pair{1, 1}, {3, 2}, {201, 10}, {499, 24}, {3001, 25}}) {
    Segments segments(instants);
    segments.begin();
    for (int i = 0; i < instants; ++i) segments.passed();
    ASSERT_EQ(segments.least().size(), static_cast<std::size_t>(count));
    for (const double seconds : segments.least()) EXPECT_LT(seconds, 1) << instants;
  }
}

TEST(Cells, HaveSegmentsThatAreAllOfTheirTime) {
  Options o;
  o.duration = 2;
  ReferenceCache references;
  Cell cell(find_case("truck_suspension"), 114, find_variant("group_symbolic_klu"), o);
  cell.verify(references);
  const auto sum = [](const std::vector<double>& segments) {
    return std::accumulate(segments.begin(), segments.end(), 0.0);
  };
  // Between two segments something else may run and leave the caches cold: not always.
  constexpr int attempts = 50;
  double largest_share = 0;
  int taken = 0;
  while (taken++ < attempts && largest_share < 0.95) {
    const double least_before = sum(cell.segments.least()), seconds = cell.time_afresh();
    const double in_segments = sum(cell.segments.samples().back());
    EXPECT_LE(in_segments, seconds);
    EXPECT_LE(sum(cell.segments.least()), std::min(least_before, in_segments));
    largest_share = std::max(largest_share, in_segments / seconds);
  }
  EXPECT_GE(largest_share, 0.95);
  EXPECT_EQ(cell.state, Timed::State::verified);
  EXPECT_EQ(cell.segments.samples().size(), static_cast<std::size_t>(taken) - 1);
}

TEST(Cells, AreVerifiedBeforeTheyAreTimed) {
  Options o;
  o.duration = 0.5;
  ReferenceCache references;
  Cell cell(find_case("truck_suspension"), 114, find_variant("group_symbolic_klu"), o);
  EXPECT_EQ(cell.name(), "truck_suspension/114/group_symbolic_klu");
  cell.verify(references);
  EXPECT_EQ(cell.state, Cell::State::verified) << cell.message;
  EXPECT_EQ(cell.errors.instants, 51);
  EXPECT_TRUE(cell.analyse().ok());
}

TEST(Cells, FailWhenTheReferenceSaysOtherwise) {
  Options o;
  o.duration = 6;
  o.step = 2;  // too coarse for Newton to follow the branch
  ReferenceCache references;
  Cell cell(find_case("four_bar"), 114, find_variant("group_symbolic_klu"), o);
  cell.verify(references);
  EXPECT_EQ(cell.state, Cell::State::failed);
  EXPECT_NE(cell.message, "");
}

TEST(Cells, SayWhyDenseGlobalSolvesAreNotRun) {
  Options o;
  const Cell cell(find_case("four_bar"), 558, find_variant("global_automatic_lapack"), o);
  EXPECT_EQ(cell.state, Cell::State::not_run);
  EXPECT_NE(cell.message.find("O(n^3)"), std::string::npos);
}

class Idle final : public Part {
  PartResult solve(State&, Level) override { return {}; }
};

TEST(Cells, AreNotTimedWithoutTheGeneratedCodeTheirIdPromises) {
  const Mechanism m = make_mechanism(four_bar(2));
  const Settings settings;
  const auto named = make_formulation(find_variant("group_symbolic_klu"), m);
  EXPECT_EQ(missing_code(*named), "");
  std::vector<Formulation::DefinedPart> parts;
  for (PartDefinition& d : make_partition(m, Partition::group))
    parts.push_back({std::move(d), std::make_unique<Idle>(), parts.size() != 1});
  const Formulation unnamed(m, std::move(parts), settings);
  EXPECT_EQ(missing_code(unnamed),
            "no generated code for 1 of 3 parts, first of group '" + m.groups[1].name + "'");
}

TEST(Structure, CountsThePartsOfEachPartition) {
  const auto found = structures(find_case("truck_suspension"), 225);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].partition, "global");
  EXPECT_EQ(found[0].parts, (std::vector<PartSizes>{{218, 1}}));
  EXPECT_EQ(found[1].partition, "group");
  EXPECT_EQ(found[1].parts, (std::vector<PartSizes>{{39, 2}, {19, 4}, {16, 4}}));
  EXPECT_EQ(found[2].partition, "block");
  int unknowns = 0;
  for (const PartSizes& p : found[2].parts) unknowns += p.count * p.unknowns;
  EXPECT_EQ(unknowns, 218);
  EXPECT_LT(found[2].parts.front().unknowns, 39);
}

struct Requests : testing::Test {
  Options options = [] {
    Options o;
    o.duration = 0.5;
    return o;
  }();
  ReferenceCache references;

  std::shared_ptr<const PlannedRequest> planned(std::string_view name) const {
    for (const RequestScene& r : request_scenes())
      if (r.name == name)
        return std::make_shared<const PlannedRequest>(
            name, parse_scene(r.scene, std::string(name), {}), options);
    throw std::invalid_argument("no such request");
  }
};

TEST_F(Requests, AreVerifiedBeforeTheyAreTimed) {
  int verified = 0;
  for (const auto& cell : make_requests(options)) {
    EXPECT_TRUE(cell->name().starts_with("truck_suspension/558/" + cell->id() + "/request:"))
        << cell->name();
    cell->verify(references);
    if (cell->is_not_run()) {  // this build has not the code, or this processor not the registers
      EXPECT_TRUE(cell->message == not_here(cell->settings) ||
                  cell->message.find("no generated code") != std::string::npos)
          << cell->name() << ": " << cell->message;
      continue;
    }
    ++verified;
    EXPECT_EQ(cell->state, Timed::State::verified) << cell->name() << ": " << cell->message;
    EXPECT_LE(cell->difference, allowed_request_difference) << cell->name();
    EXPECT_EQ(cell->errors.instants, 51);
    EXPECT_LT(cell->request().unknowns, cell->request().all_unknowns);
    EXPECT_TRUE(cell->analyse().ok());
  }
  EXPECT_GE(verified, 8);
}

TEST_F(Requests, DeliverWhatIsAskedAndNothingElse) {
  const auto request = planned("damper");
  ASSERT_EQ(request->asked.size(), 1u);
  RequestedDelivery delivery(request->asked);
  const auto f = make_formulation(find_variant("block_symbolic_inlined"), request->plan.mechanism);
  f->solve_only(request->plan.levels);
  ASSERT_TRUE(f->run(request->grid, {request->plan.level()}, delivery).ok());
  ASSERT_EQ(delivery.q().size(), 1u);
  ASSERT_EQ(delivery.qd().size(), 1u);
  EXPECT_TRUE(delivery.qdd().empty());
  const int s10 = request->asked[0].kept;
  EXPECT_EQ(delivery.q()[0], f->q()[s10]);
  EXPECT_EQ(delivery.qd()[0], f->qd()[s10]);
}

TEST_F(Requests, DifferWhereSomethingNeededIsLeftOut) {
  const auto request = planned("damper");
  const Variant& v = find_variant("global_automatic_klu");
  const auto whole = make_formulation(v, request->whole);
  const auto kept = make_formulation(v, request->plan.mechanism);
  const auto differences = [&](Level level) {
    return largest_differences(*whole, *kept, request->asked, level, request->grid);
  };
  EXPECT_LT(differences(Level::velocity).velocity, 1e-9);
  EXPECT_GT(differences(Level::position).velocity, 1e-3);  // its velocities are never solved
}

TEST_F(Requests, FailWhereTheWholeMechanismCannotBeSolved) {
  Scene scene = truck_suspension(1);
  scene.request = {{Wanted::Kind::point, 0, Level::position}};
  scene.motions.front() = HarmonicSum{5, {}};  // out of the axle's reach
  RequestCell cell(std::make_shared<const PlannedRequest>("far", scene, options),
                   find_variant("global_automatic_klu"));
  cell.verify(references);
  EXPECT_EQ(cell.state, Timed::State::failed);
  EXPECT_TRUE(cell.message.starts_with("the whole mechanism: ")) << cell.message;
  EXPECT_FALSE(cell.is_timed());
}

int run_bench(const std::string& flags) {
  const int status = std::system((DESMO_BENCH " " + flags + " >/dev/null 2>&1").c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(Bench, ExitCodesSayWhatHappened) {
  const std::string record = testing::TempDir() + "desmo_record.json";
  const std::string one = " --benchmark_filter=four_bar/114/group_symbolic_klu$";
  std::filesystem::remove(record);
  EXPECT_EQ(run_bench("--duration=0.2 --record=" + record + one), 0);
  std::ifstream in(record);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  EXPECT_NE(text.find("\"status\":\"ok\""), std::string::npos);
  for (const char* key :
       {"cpu_seconds", "repetitions", "machine", "model", "results", "turbo", "link", "binary",
        "reducer", "segments", "segment_seconds", "segment_updates", "segment_samples"})
    EXPECT_NE(text.find("\"" + std::string(key) + "\""), std::string::npos) << key;

  EXPECT_EQ(run_bench("--step=2 --record=" + record + one), 1);
  std::ifstream again(record);
  const std::string failed{std::istreambuf_iterator<char>(again), {}};
  EXPECT_NE(failed.find("\"status\":\"failed\""), std::string::npos);
  EXPECT_EQ(failed.find("\"cpu_seconds\""), std::string::npos);

  EXPECT_EQ(run_bench("--benchmark_filter=nothing_of_that_name"), 64);
  EXPECT_EQ(run_bench("--benchmark_list_tests"), 0);
  EXPECT_EQ(run_bench("--benchmark_list_tests --benchmark_filter=four_bar/114/group_symbolic_klu$"),
            0);
  EXPECT_EQ(run_bench("--benchmark_report_aggregates_only" + one), 64);
  EXPECT_EQ(run_bench("--step=zero"), 64);
  EXPECT_EQ(run_bench("--no_such_flag"), 64);
  EXPECT_EQ(run_bench("--duration=0.2 --record=/nonexistent/record.json" + one), 74);
  EXPECT_FALSE(std::filesystem::exists(record + ".unfinished"));
  EXPECT_EQ(run_bench("--duration=0.2 --record=/dev/null" + one), 0);
  EXPECT_FALSE(std::filesystem::is_regular_file("/dev/null"));
}

TEST(Bench, RunsFormulationsWithSettingsBesideTheTable) {
  const std::string id = "group_automatic_klu/guess:hermite5/jacobian:step";
  EXPECT_EQ(run_bench("--duration=0.2 --formulation=" + id + " '--benchmark_filter=four_bar/114/" +
                      id + "'"),
            0);
  EXPECT_EQ(run_bench("--formulation=group_automatic_klu/guess:cubic"), 64);
  EXPECT_EQ(run_bench("--formulation=group_automatic_klu/scalar:float"), 64);
}

TEST(Bench, RecordsAreReadByTheReport) {
  const std::string record = testing::TempDir() + "desmo_end_to_end.json";
  const std::string report = DESMO_REPORT " tables " + record + " >/dev/null 2>&1";
  // With a cell that is not run, and with one that fails.
  ASSERT_EQ(run_bench("--duration=0.02 --record=" + record +
                      " '--benchmark_filter=/(114|225)/global_automatic_(klu|lapack)$'"),
            0);
  EXPECT_EQ(std::system(report.c_str()), 0);
  std::ifstream in(record);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  for (const char* of : {"four_bar\",\"coordinates\":114", "four_bar\",\"coordinates\":225",
                         "truck_suspension\",\"coordinates\":225"})
    EXPECT_NE(text.find("{\"case\":\"" + std::string(of)), std::string::npos) << of;
  ASSERT_EQ(run_bench("--step=2 --record=" + record +
                      " --benchmark_filter=four_bar/114/group_symbolic_klu"),
            1);
  EXPECT_EQ(std::system(report.c_str()), 0);
  // With requests, with and without everything beside them.
  for (const std::string filter : {"558/block_symbolic_inlined", "request:(damper|axle)$"}) {
    ASSERT_EQ(
        run_bench("--duration=0.02 --record=" + record + " '--benchmark_filter=" + filter + "'"),
        0);
    EXPECT_EQ(std::system((report + " && " DESMO_REPORT " tables " + record +
                           " | grep -q 'What a request costs'")
                              .c_str()),
              0);
  }
  std::filesystem::remove(record);
}

}  // namespace
}  // namespace desmo::suite
