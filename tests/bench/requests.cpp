// Requests of desmo_bench: solved for what they need, and compared with the whole.

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <string_view>

#include "bench/experiments/paper/options.h"
#include "bench/experiments/paper/request.h"
#include "bench/kit/verification.h"
#include "cases/io/files.h"
#include "cases/library/library.h"
#include "cases/mechanism/names.h"
#include "formulations/id.h"

namespace desmo::paper::requests_test {
namespace {

using namespace bench;

struct Requests : testing::Test {
  Options options = [] {
    Options o;
    o.duration = 0.5;
    return o;
  }();

  std::shared_ptr<const PlannedRequest> planned(std::string_view name) const {
    const RequestScene& request = entry_named(name, request_scenes(), "request");
    return std::make_shared<const PlannedRequest>(
        name, parse_scene(request.scene, std::string(name), {}), options);
  }
};

TEST_F(Requests, AreVerifiedBeforeTheyAreTimed) {
  int verified = 0;
  for (const auto& candidate : make_request_candidates(options)) {
    EXPECT_TRUE(
        candidate->name().starts_with("truck_suspension/558/" + candidate->id() + "/request:"))
        << candidate->name();
    candidate->verify();
    if (candidate->is_not_run()) {  // this processor has not the registers
      EXPECT_EQ(candidate->message(), unavailable_reason(candidate->settings()));
      continue;
    }
    ++verified;
    EXPECT_TRUE(candidate->is_verified()) << candidate->name() << ": " << candidate->message();
    EXPECT_EQ(candidate->verifying_run().errors.instants, 51);
    EXPECT_TRUE(candidate->time_afresh()) << candidate->message();
  }
  for (const RequestScene& source : request_scenes())
    EXPECT_LT(planned(source.name)->unknowns, planned(source.name)->all_unknowns) << source.name;
  EXPECT_GE(verified, 8);
}

TEST_F(Requests, FailWhereSomethingNeededIsLeftOut) {
  auto request = std::make_shared<PlannedRequest>(*planned("damper"));
  ASSERT_EQ(request->delivered.size(), 1u);
  EXPECT_EQ(request->compared.size(), 2u);                    // its position and its velocity
  for (int i = 0; i < std::ssize(request->plan.levels); ++i)  // not what its velocity needs
    if (i != request->delivered[0]) request->plan.levels[i] = Level::position;
  RequestCandidate candidate(request, parse_id("group_symbolic_inlined"));
  candidate.verify();
  EXPECT_TRUE(candidate.is_failed());
  EXPECT_TRUE(candidate.message().starts_with("differs from the reference")) << candidate.message();
  EXPECT_FALSE(candidate.is_timed());
}

}  // namespace
}  // namespace desmo::paper::requests_test
