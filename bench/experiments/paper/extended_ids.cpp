#include "bench/experiments/paper/extended_ids.h"

#include <utility>

#include "bench/kit/checked_run.h"

namespace desmo::paper {

std::vector<TimedConfiguration> with_counterpart(std::string_view id) {
  const Configuration c = parse_id(id);
  std::vector<TimedConfiguration> all{{c}};
  if (c.settings.threads == 1) return all;
  all.push_back({c, bench::Clock::wall});
  all.back().settings.threads = 1;
  return all;
}

std::vector<TimedConfiguration> beyond_the_table() {
  std::vector<TimedConfiguration> all;
  for (const std::string_view id : extended_ids)
    for (TimedConfiguration& c : with_counterpart(id)) all.push_back(std::move(c));
  all.push_back({parse_id(reference_of_one_block)});
  for (const std::string_view id : bench::checked_ids)
    for (const auto& [suffix, mode] : bench::check_suffixes)
      all.push_back({{&find_variant(id), {}}, bench::Clock::cpu, mode});
  return all;
}

}  // namespace desmo::paper
