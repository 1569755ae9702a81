#include "bench/kit/record/recording.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "bench/kit/record/environment.h"

namespace desmo::bench {

namespace {

const std::string& required(const std::string& path) {
  if (path.empty())
    throw std::invalid_argument("--record FILE is missing: what is measured goes there");
  return path;
}

}  // namespace

Recording::Recording(const std::string& path, const std::string& command)
    : file_(required(path)), run_{utc_now(), command, load_averages(), {}} {}

void Recording::write(const TimeGrid& grid, const nlohmann::ordered_json& lists) {
  run_.load_after = load_averages();
  file_.write(record_text(run_, grid, lists));
}

}  // namespace desmo::bench
