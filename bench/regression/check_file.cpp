#include "bench/regression/check_file.h"

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace desmo::regression {

Json load_check(const std::string& path) {
  std::ifstream in(path);
  try {
    return Json::parse(in);
  } catch (const nlohmann::json::exception& e) {
    throw std::runtime_error("'" + path + "' is not a results file: " + e.what());
  }
}

void save_check(const Json& check, const std::string& path) {
  const std::string unfinished = path + ".unfinished";
  std::ofstream out(unfinished);
  out << check.dump() << '\n';
  out.close();
  if (out && std::rename(unfinished.c_str(), path.c_str()) == 0) return;
  std::remove(unfinished.c_str());
  throw std::runtime_error("'" + path + "' cannot be written");
}

}  // namespace desmo::regression
