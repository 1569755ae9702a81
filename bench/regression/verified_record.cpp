#include "bench/regression/verified_record.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "bench/experiments/paper/case_candidate.h"
#include "bench/kit/record/environment.h"
#include "bench/kit/record/environment_json.h"
#include "bench/regression/cell_name.h"

namespace desmo::regression {

namespace {

using Json = nlohmann::ordered_json;

Json verified(const CellName& name, const paper::Options& options,
              bench::ReferenceCache& references) {
  Json j = {{"case", name.case_name}, {"coordinates", name.coordinates}, {"id", name.id}};
  try {
    paper::CaseCandidate cell(find_case(name.case_name), name.coordinates, find_variant(name.id),
                              options);
    cell.verify(references);
    if (cell.state != bench::Candidate::State::verified) {
      j["status"] = cell.is_failed() ? "failed" : "not_run";
      j["message"] = cell.message;
      return j;
    }
    j["status"] = "ok";
    j["machine"] = bench::this_machine().cpu;
    j["model"] = cell.model;
    j["results"] = cell.results;
    j["verification"] = bench::errors_json(cell.errors);
  } catch (const std::invalid_argument& e) {
    const std::string message = e.what();  // the lines that follow list what there is
    j["status"] = "not_run";
    j["message"] = message.substr(0, message.find('\n'));
  }
  return j;
}

}  // namespace

std::string verified_record(int instants, const std::vector<std::string>& cells) {
  paper::Options options;
  options.step = 0.01;
  options.duration = options.step * (instants - 1);
  const TimeGrid grid{0, options.step, instants};
  const bench::Run run{bench::utc_now(), "desmo_probe", bench::load_averages(), {}};
  Json record = {{"schema", "desmo-results"}, {"schema_version", bench::schema_version}};
  record["record"] = bench::environment_json(run, grid);
  Json& list = record["paper"]["cells"] = Json::array();
  bench::ReferenceCache references;
  for (const std::string& cell : cells)
    list.push_back(verified(parse_cell(cell), options, references));
  return record.dump();
}

}  // namespace desmo::regression
