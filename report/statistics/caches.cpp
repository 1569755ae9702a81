#include "report/statistics/caches.h"

#include <algorithm>
#include <sstream>

namespace desmo::report {

std::vector<Cache> data_caches(const Machine& machine) {
  std::vector<Cache> caches;
  for (const std::string& text : machine.caches) {
    std::istringstream words(text);
    std::string name, type, unit;
    double size = 0;
    if (words >> name >> type >> size >> unit && type != "Instruction" && unit.starts_with("KiB") &&
        size > 0)
      caches.push_back({name, 1024 * size});
  }
  std::ranges::stable_sort(caches, {}, &Cache::bytes);
  return caches;
}

std::string held_by(const std::vector<Cache>& caches, double bytes) {
  if (caches.empty()) return {};
  for (const Cache& cache : caches)
    if (bytes <= cache.bytes) return "in " + cache.name;
  return "beyond " + caches.back().name;
}

std::vector<std::string> holders(const std::vector<Cache>& caches) {
  std::vector<std::string> all;
  for (const Cache& cache : caches) all.push_back("in " + cache.name);
  if (!caches.empty()) all.push_back("beyond " + caches.back().name);
  return all;
}

}  // namespace desmo::report
