#include "bench/regression/verified_record.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "bench/kit/cell.h"
#include "bench/kit/environment.h"
#include "bench/kit/environment_json.h"
#include "bench/regression/cell_name.h"

namespace desmo::regression {

namespace {

using Json = nlohmann::ordered_json;

Json verified(const CellName& name, const suite::Options& options,
              suite::ReferenceCache& references) {
  Json j = {{"case", name.case_name}, {"coordinates", name.coordinates}, {"id", name.id}};
  try {
    suite::Cell cell(find_case(name.case_name), name.coordinates, find_variant(name.id), options);
    cell.verify(references);
    if (cell.state != suite::Timed::State::verified) {
      j["status"] = cell.is_failed() ? "failed" : "not_run";
      j["message"] = cell.message;
      return j;
    }
    j["status"] = "ok";
    j["machine"] = suite::this_machine().cpu;
    j["model"] = cell.model;
    j["results"] = cell.results;
    j["verification"] = suite::errors_json(cell.errors);
  } catch (const std::invalid_argument& e) {
    const std::string message = e.what();  // the lines that follow list what there is
    j["status"] = "not_run";
    j["message"] = message.substr(0, message.find('\n'));
  }
  return j;
}

}  // namespace

std::string verified_record(int instants, const std::vector<std::string>& cells) {
  suite::Options options;
  options.step = 0.01;
  options.duration = options.step * (instants - 1);
  const TimeGrid grid{0, options.step, instants};
  const suite::Run run{suite::utc_now(), "desmo_probe", suite::load_averages(), {}};
  Json record = {{"schema", "desmo-results"}, {"schema_version", suite::schema_version}};
  record["record"] = suite::environment_json(run, grid);
  Json& list = record["paper"]["cells"] = Json::array();
  suite::ReferenceCache references;
  for (const std::string& cell : cells)
    list.push_back(verified(parse_cell(cell), options, references));
  return record.dump();
}

}  // namespace desmo::regression
