// Steps at 1 kHz with driver values that come one by one, as in a controller.
#include <desmo/cases.h>
#include <desmo/formulation.h>
#include <desmo/live_run.h>
#include <desmo/model.h>

#include <cmath>
#include <cstdio>
#include <vector>

int main() {
  const desmo::Model model = desmo::make_model(desmo::truck_suspension(1));
  const auto formulation =
      desmo::make_formulation(desmo::find_variant("group_symbolic_explicit"), model);
  desmo::LiveOptions options;
  options.scales =
      desmo::Scales{.length = {1, 1, 10}, .rotation = {1, 1, 10}};  // m, rad; 1/s, 1/s²
  desmo::LiveRun run(*formulation, options);

  const int drivers = model.degrees_of_freedom();
  std::vector<double> z(drivers), zd(drivers), zdd(drivers);
  std::vector<double> rest;  // where the estimate has the drivers
  for (const desmo::Driver& d : model.drivers)
    rest.push_back(model.estimate[model.entities[d.coordinate].first]);
  int degraded = 0, failed = 0;
  for (int i = 0; i <= 2000; ++i) {
    const double t = 1e-3 * i, w = 6;
    for (int d = 0; d < drivers; ++d) {  // what sensors would say
      z[d] = rest[d] + 0.01 * (1 - std::cos(w * t));
      zd[d] = 0.01 * w * std::sin(w * t);
      zdd[d] = 0.01 * w * w * std::cos(w * t);
    }
    if (i == 1000) z[0] = NAN;  // and when one of them is broken
    const desmo::LiveSummary answer = run.step({t, z, zd, zdd});
    degraded += answer.outcome() == desmo::Outcome::degraded;
    failed += answer.outcome() == desmo::Outcome::failed;
  }
  std::printf("%d rows degraded, %d failed; the left wheel at %.6f m at t = %.3f s\n", degraded,
              failed, model.value("axle1/zL", run.q()), run.time());
  return degraded == 0 && failed == 1 && run.time() == 2 ? 0 : 1;
}
