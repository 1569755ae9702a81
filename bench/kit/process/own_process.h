#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace desmo::bench {

/// Does some work in a process of its own, and returns the result. The process begins as a copy of
/// this one, and ends with the work. So no candidate is affected by earlier ones. Above all, memory
/// that earlier ones have left can make the same code a tenth faster or slower for as long as a
/// process lives. The caller must have one thread.
///
/// name: for errors. Throws std::runtime_error
/// - where the work throws; writes its message to standard error
/// - where a signal ends the process
/// - where the system has no process or temporary file to give
nlohmann::ordered_json in_own_process(const std::string& name,
                                      const std::function<nlohmann::ordered_json()>& work);

}  // namespace desmo::bench
