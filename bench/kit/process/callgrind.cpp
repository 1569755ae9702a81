#include "bench/kit/process/callgrind.h"

#include <gnu/libc-version.h>

#include <algorithm>
#include <atomic>
#include <future>
#include <stdexcept>
#include <string_view>

#include "bench/kit/process/child.h"
#include "bench/kit/process/progress.h"

namespace desmo::bench {

namespace {

/// Returns the launch of valgrind by env, which looks for it on PATH.
Launch valgrind(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"/usr/bin/env", "valgrind"});
  return fixed_launch(std::move(arguments));
}

std::int64_t collected(const std::string& log) {
  constexpr std::string_view mark = "Collected : ";
  const std::size_t at = log.find(mark);
  return at == std::string::npos ? 0 : std::stoll(log.substr(at + mark.size()));
}

}  // namespace

std::int64_t count_steps(const std::string& of, std::vector<std::string> command) try {
  command.insert(command.begin(), {"--tool=callgrind", "--callgrind-out-file=/dev/null",
                                   "--log-fd=1", "--toggle-collect=desmo_counted_steps"});
  Launch launch = valgrind(std::move(command));
  launch.environment.push_back("OPENBLAS_CORETYPE=Haswell");  // callgrind can run this code
  std::string log;
  const int code = Child(launch).finish(log);
  const std::int64_t instructions = collected(log);
  if (code != 0 || instructions <= 0)
    throw std::runtime_error("exit code " + std::to_string(code) + "\n" + log);
  return instructions;
} catch (const std::runtime_error& error) {
  throw std::runtime_error("the instructions of " + of + " cannot be counted: " + error.what());
}

std::string counting_tool() {
  std::string version;
  if (Child(valgrind({"--version"})).finish(version) != 0) return {};
  return version.substr(0, version.find('\n')) + ", glibc " + gnu_get_libc_version();
}

void count_on_all_cores(std::size_t n, const std::function<void(std::size_t)>& count) {
  Progress progress("instruction counts", static_cast<double>(n));
  std::atomic<std::size_t> next = 0;
  const auto some = [&] {
    for (std::size_t i; (i = next++) < n; progress.add_done()) count(i);
  };
  std::vector<std::future<void>> workers;
  for (std::size_t i = 0; i < std::max<std::size_t>(1, usable_cores().size()); ++i)
    workers.push_back(std::async(std::launch::async, some));
  for (std::future<void>& worker : workers) worker.get();
}

}  // namespace desmo::bench
