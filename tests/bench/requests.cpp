// Requests of desmo_bench: solved for what they need, and compared with the whole.

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

#include "bench/experiments/paper/options.h"
#include "bench/experiments/paper/request.h"
#include "bench/kit/verification.h"
#include "cases/generators/cases.h"
#include "cases/io/files.h"
#include "cases/library/library.h"
#include "formulations/variants.h"

namespace desmo::paper::requests_test {
namespace {

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
  for (const auto& candidate : make_request_candidates(options)) {
    EXPECT_TRUE(
        candidate->name().starts_with("truck_suspension/558/" + candidate->id() + "/request:"))
        << candidate->name();
    candidate->verify(references);
    if (candidate
            ->is_not_run()) {  // this build has not the code, or this processor not the registers
      EXPECT_TRUE(candidate->message() == unavailable_reason(candidate->settings()) ||
                  candidate->message().find("no generated code") != std::string::npos)
          << candidate->name() << ": " << candidate->message();
      continue;
    }
    ++verified;
    EXPECT_TRUE(candidate->is_verified()) << candidate->name() << ": " << candidate->message();
    EXPECT_LE(candidate->difference(), allowed_request_difference) << candidate->name();
    EXPECT_EQ(candidate->verifying_run().errors.instants, 51);
    EXPECT_LT(candidate->request().unknowns, candidate->request().all_unknowns);
    candidate->measure([](VerifiedCandidate& verified) { verified.time_afresh(); });
    EXPECT_TRUE(candidate->is_verified()) << candidate->message();
  }
  EXPECT_GE(verified, 8);
}

TEST_F(Requests, DeliverWhatIsAskedAndNothingElse) {
  const auto request = planned("damper");
  ASSERT_EQ(request->asked.size(), 1u);
  Delivery delivery(request->coordinates.size(), request->plan.level());
  const auto f = make_formulation(find_variant("block_symbolic_inlined"), request->plan.model);
  f->solve_only(request->plan.levels);
  ASSERT_TRUE(f->run(request->grid, {request->plan.level(), request->coordinates}, delivery).ok());
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
  const auto kept = make_formulation(v, request->plan.model);
  const auto differences = [&](Level level) {
    return max_differences(*whole, *kept, request->asked, level, request->grid);
  };
  EXPECT_LT(differences(Level::velocity).velocity, 1e-9);
  EXPECT_GT(differences(Level::position).velocity, 1e-3);  // its velocities are never solved
}

TEST_F(Requests, FailWhereTheWholeMechanismCannotBeSolved) {
  Scene scene = truck_suspension(1);
  scene.request = {{RequestedEntity::Kind::point, 0, Level::position}};
  scene.motions.front() = HarmonicSum{5, {}};  // out of the axle's reach
  RequestCandidate candidate(std::make_shared<const PlannedRequest>("far", scene, options),
                             find_variant("global_automatic_klu"));
  candidate.verify(references);
  EXPECT_TRUE(candidate.is_failed());
  EXPECT_TRUE(candidate.message().starts_with("the whole mechanism: ")) << candidate.message();
  EXPECT_FALSE(candidate.is_timed());
}

}  // namespace
}  // namespace desmo::paper::requests_test
