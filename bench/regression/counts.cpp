#include "bench/regression/counts.h"

#include <gnu/libc-version.h>

#include <algorithm>
#include <atomic>
#include <future>
#include <stdexcept>
#include <string_view>

#include "bench/regression/cell_name.h"
#include "bench/regression/cells.h"
#include "bench/suite/progress.h"

namespace desmo::regression {

namespace {

/// By way of env, which looks for it.
Launch valgrind(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"/usr/bin/env", "valgrind"});
  return fixed_launch(std::move(arguments));
}

std::int64_t collected(const std::string& log) {
  constexpr std::string_view mark = "Collected : ";
  const std::size_t at = log.find(mark);
  return at == std::string::npos ? 0 : std::stoll(log.substr(at + mark.size()));
}

std::int64_t count(const Side& side, const std::string& name) {
  const CellName cell = parse_cell(name);
  Launch launch = valgrind({"--tool=callgrind", "--callgrind-out-file=/dev/null", "--log-fd=1",
                            "--toggle-collect=desmo_counted_steps", side.folder + "/desmo_steps",
                            cell.case_name, std::to_string(cell.coordinates), cell.id,
                            std::to_string(steps), std::to_string(iterations),
                            std::to_string(name == side.slowed ? side.percent : 0)});
  launch.environment.push_back("OPENBLAS_CORETYPE=Haswell");  // that callgrind knows
  std::string log;
  const int code = run_to_end(launch, log);
  const std::int64_t instructions = collected(log);
  if (code != 0 || instructions <= 0)
    throw std::runtime_error("the instructions of " + name + " cannot be counted in " + side.name +
                             ": exit code " + std::to_string(code) + "\n" + log);
  return instructions;
}

}  // namespace

Counts count_instructions(const std::vector<Counted>& all) {
  suite::Progress progress("instruction counts", static_cast<int>(all.size()));
  std::vector<std::int64_t> instructions(all.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i; (i = next++) < all.size(); progress.one_done())
      instructions[i] = count(*all[i].side, all[i].cell);
  };
  std::vector<std::future<void>> workers;
  for (std::size_t i = 0; i < std::max<std::size_t>(1, usable_cores().size()); ++i)
    workers.push_back(std::async(std::launch::async, work));
  for (std::future<void>& worker : workers) worker.get();
  Counts counts;
  for (std::size_t i = 0; i < all.size(); ++i)
    counts[all[i].cell][all[i].side->name] = instructions[i];
  return counts;
}

std::string counting_tool() {
  std::string version;
  if (run_to_end(valgrind({"--version"}), version) != 0) return {};
  return version.substr(0, version.find('\n')) + ", glibc " + gnu_get_libc_version();
}

}  // namespace desmo::regression
