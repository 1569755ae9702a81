#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace desmo::bench {

/// Returns the instructions of desmo_counted_steps in a run of desmo_steps, counted by callgrind in
/// a fixed environment. callgrind presents the same processor to every program, so that counts do
/// not depend on the machine's processor.
///
/// of: name of what is counted, for errors. command: path and arguments of desmo_steps. Throws
/// std::runtime_error, naming what is counted, with exit code and standard output when that fails.
std::int64_t count_steps(const std::string& of, std::vector<std::string> command);

/// Returns the versions of tools on which counts depend, "valgrind-3.19.0, glibc 2.36"; empty
/// without valgrind.
std::string counting_tool();

/// Calls count(0) … count(n − 1) on a thread for each core that this process may use. Shows
/// progress. Throws what a call throws, after all threads have ended.
void count_on_all_cores(std::size_t n, const std::function<void(std::size_t)>& count);

}  // namespace desmo::bench
