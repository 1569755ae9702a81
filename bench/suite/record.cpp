#include "bench/suite/record.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "bench/suite/environment.h"
#include "formulations/algebra/blas.h"

namespace desmo::suite {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* schema_version = "1.1.0";

Json environment(const Run& run, const TimeGrid& grid) {
  const Machine machine = this_machine();
  const Build build = this_build();
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
            {"load_before", run.load_before},
            {"load_after", run.load_after}}},
          {"build", {{"type", build.type}, {"compiler", build.compiler}, {"flags", build.flags}}},
          {"libraries", libraries},
          {"blas", {{"core", blas.core}, {"threads", blas.threads}}},
          {"settings",
           {{"tolerance", settings.tolerance},
            {"max_iterations", settings.max_iterations},
            {"guess", "previous position"},
            {"step_seconds", grid.step},
            {"duration_seconds", grid.time(grid.instants - 1)},
            {"instants", grid.instants},
            {"clock", "CPU time of the thread"},
            {"allowed",
             {{"position", allowed.position},
              {"velocity", allowed.velocity},
              {"acceleration", allowed.acceleration}}}}}};
}

Json cell_json(const Cell& cell) {
  Json j = {
      {"case", cell.definition.name}, {"coordinates", cell.coordinates}, {"id", cell.variant.id}};
  if (cell.state == Cell::State::not_run) {
    j["status"] = "not_run";
    j["message"] = cell.message;
    return j;
  }
  const bool ok = cell.state == Cell::State::verified && !cell.cpu_seconds.empty();
  j["groups"] = cell.groups;
  j["degrees_of_freedom"] = cell.degrees_of_freedom;
  j["status"] = ok ? "ok" : "failed";
  if (!ok) {
    j["message"] = cell.message.empty() ? "not timed" : cell.message;
    return j;
  }
  j["verification"] = {{"instants", cell.errors.instants},
                       {"position", cell.errors.position},
                       {"velocity", cell.errors.velocity},
                       {"acceleration", cell.errors.acceleration}};
  j["cpu_seconds"] = cell.cpu_seconds;
  j["setup_seconds"] = cell.setup_seconds;
  j["iterations_per_step"] = cell.iterations_per_step;
  j["residual"] = cell.residual;
  return j;
}

Json profile_json(const Cell& cell) {
  Json seconds;
  for (int p = 0; p < phase_count; ++p) seconds[phase_names[p]] = cell.phases->seconds[p];
  seconds["rest"] = cell.phases->rest;
  return {{"case", cell.definition.name},
          {"coordinates", cell.coordinates},
          {"id", cell.variant.id},
          {"seconds_per_step", seconds},
          {"total_range", {cell.phases->least_total, cell.phases->most_total}}};
}

}  // namespace

RecordFile::RecordFile(const std::string& path) : path_(path) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (fs::is_symlink(path, ignored)) path_ = fs::weakly_canonical(path, ignored).string();
  const bool special = fs::exists(path_, ignored) && !fs::is_regular_file(path_, ignored);
  if (!special) unfinished_ = path_ + ".unfinished";
  out_.open(special ? path_ : unfinished_);
  if (!out_) throw std::runtime_error("cannot write the record '" + path + "'");
}

RecordFile::~RecordFile() {
  std::error_code ignored;
  if (!unfinished_.empty()) std::filesystem::remove(unfinished_, ignored);
}

void RecordFile::write(const Run& run, const std::vector<Cell*>& cells) {
  Json all = {{"schema", "desmo-results"}, {"version", schema_version}};
  all["record"] = environment(run, cells.front()->grid);
  all["cells"] = Json::array();
  all["profiles"] = Json::array();
  for (const Cell* cell : cells) {
    all["cells"].push_back(cell_json(*cell));
    if (cell->phases && cell->state == Cell::State::verified)
      all["profiles"].push_back(profile_json(*cell));
  }
  out_ << all.dump(1) << '\n';
  out_.close();
  if (!out_ || (!unfinished_.empty() && std::rename(unfinished_.c_str(), path_.c_str()) != 0))
    throw std::runtime_error("cannot write the record '" + path_ + "'");
  unfinished_.clear();
}

}  // namespace desmo::suite
