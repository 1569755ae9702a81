#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace desmo::bench {

/// Returns the instructions of desmo_counted_steps in a run of desmo_steps, counted by callgrind in
/// a fixed environment. callgrind shows every program the same processor, so counts do not depend
/// on the machine's.
///
/// of: name of what is counted, for errors. command: path and arguments of desmo_steps. Throws
/// std::runtime_error, naming what is counted, with exit code and standard output when that fails.
std::int64_t count_steps(const std::string& of, std::vector<std::string> command);

/// Returns the tools on which counts depend, too: "valgrind-3.19.0, glibc 2.36"; empty without
/// valgrind.
std::string counting_tool();

/// Calls count(0) … count(n − 1) on as many threads as this process has cores, and shows progress.
/// Throws what a call throws, after all threads have ended.
void count_on_all_cores(std::size_t n, const std::function<void(std::size_t)>& count);

}  // namespace desmo::bench
