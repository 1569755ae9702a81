#include "bench/kit/record/environment_json.h"

#include <nlohmann/json.hpp>

#include "bench/experiments/paper/request.h"
#include "bench/kit/record/binary.h"
#include "bench/kit/record/environment.h"
#include "formulations/algebra/blas.h"
#include "formulations/variants.h"

namespace desmo::bench {

using Json = nlohmann::ordered_json;

Json environment_json(const Run& run, const TimeGrid& grid) {
  const Machine machine = this_machine();
  const Build build = this_build();
  const Link link = this_link();
  const BlasEnvironment blas = blas_environment();
  const Settings settings;
  Json libraries = Json::object();
  for (const auto& [name, version] : library_versions()) libraries[name] = version;
  return {{"date", run.date},
          {"commit", build.commit},
          {"dirty", build.dirty},
          {"command", run.command},
          {"machine",
           {{"cpu", machine.cpu},
            {"cores", machine.cores},
            {"caches", machine.caches},
            {"kernel", machine.kernel},
            {"governor", machine.governor},
            {"turbo", machine.turbo},
            {"load_before", run.load_before},
            {"load_after", run.load_after}}},
          {"build",
           {{"type", build.type},
            {"compiler", build.compiler},
            {"flags", build.flags},
            {"link", {{"type", link.type}, {"flags", link.flags}, {"libraries", link.libraries}}},
            {"binary", binary_digest()}}},
          {"libraries", libraries},
          {"blas", {{"core", blas.core}, {"threads", blas.threads}}},
          {"settings",
           {{"tolerance", settings.tolerance},
            {"max_iterations", settings.max_iterations},
            {"guess", "previous position"},
            {"step_seconds", grid.step},
            {"duration_seconds", grid.time(grid.instants - 1)},
            {"instants", grid.instants},
            {"allowed",
             {{"position", allowed.position},
              {"velocity", allowed.velocity},
              {"acceleration", allowed.acceleration},
              {"request", paper::allowed_request_difference}}}}}};
}

Json errors_json(const Errors& errors) {
  return {{"instants", errors.instants},
          {"position", errors.position},
          {"velocity", errors.velocity},
          {"acceleration", errors.acceleration}};
}

}  // namespace desmo::bench
