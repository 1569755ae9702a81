#include "bench/regression/measured_candidates.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "bench/kit/formulation_candidate.h"
#include "bench/kit/record/environment.h"
#include "bench/kit/record/record.h"
#include "bench/regression/stepped_formulation.h"
#include "formulations/algebra/backend.h"
#include "formulations/variants.h"

namespace desmo::regression {

namespace {

using Json = nlohmann::ordered_json;

Json verified(const std::string& name, int instants) {
  const bench::CandidateName parsed = bench::parse_name(name);
  Json j = {{"case", parsed.case_name}, {"coordinates", parsed.coordinates}, {"id", parsed.id}};
  try {
    const bench::Problem problem = problem_of(parsed, instants);
    bench::FormulationCandidate candidate(problem, parsed.id, Settings{});
    candidate.verify();
    if (!candidate.is_verified()) {
      j["status"] = candidate.is_failed() ? "failed" : "not_run";
      j["message"] = candidate.message();
      return j;
    }
    j["status"] = "ok";
    j["machine"] = bench::processor_name();
    j["model"] = candidate.verifying_run().model;
    j["results"] = candidate.verifying_run().results;
    j["verification"] = bench::errors_json(candidate.verifying_run().errors);
  } catch (const std::invalid_argument& e) {
    const std::string message = e.what();  // lines after its first list known names
    j["status"] = "not_run";
    j["message"] = message.substr(0, message.find('\n'));
  }
  return j;
}

}  // namespace

std::vector<std::string> measured_candidates() {
  std::vector<std::string> names{
      "four_bar/114/global_automatic_klu",
      "four_bar/114/group_symbolic_inlined",
      "four_bar/54/block_symbolic_klu",
      "four_bar/24/global_automatic_lapack",
      "four_bar/24/global_symbolic_umfpack",
      "truck_suspension/114/global_automatic_klu",
      "truck_suspension/114/global_symbolic_cholmod",
      "truck_suspension/114/group_automatic_cholmod",
      "truck_suspension/114/group_automatic_spqr",
      "truck_suspension/114/group_automatic_sparselu",
      "truck_suspension/114/group_symbolic_klu",
      "truck_suspension/114/group_symbolic_eigen",
      "truck_suspension/114/group_symbolic_lapack",
      "truck_suspension/114/group_symbolic_explicit",
      "truck_suspension/114/block_symbolic_inlined",
  };
  // Adds a candidate of the truck for each present algebra that no name ends with. It is the first
  // variant in groups with that algebra or, if there is none, the first variant of all.
  for (const bool in_groups : {true, false})
    for (const Variant& v : variants()) {
      if (const Backend* const b = find_backend(v.algebra); b && b->absence) continue;
      if (in_groups && v.partition != Partition::group) continue;
      const std::string algebra = v.id.substr(v.id.rfind('_'));
      if (std::ranges::none_of(names, [&](const auto& name) { return name.ends_with(algebra); }))
        names.push_back("truck_suspension/114/" + v.id);
    }
  return names;
}

std::string verified_record(int instants, const std::vector<std::string>& names) {
  Json record = bench::record_head("desmo_probe", {0, 0.01, instants});
  Json& list = record["paper"]["candidates"] = Json::array();
  for (const std::string& name : names) list.push_back(verified(name, instants));
  return record.dump();
}

}  // namespace desmo::regression
