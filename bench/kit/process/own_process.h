#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace desmo::bench {

/// Does some work in a process of its own, which begins as this one is now and ends with the work,
/// and returns what it makes. What ran before leaves traces in a process, in the places of its
/// memory above all, that make the same code a tenth faster or slower for as long as it lives; a
/// process that does little leaves the least. The caller must have one thread.
///
/// name: for errors. Throws std::runtime_error where the work throws, which it has then said on
/// standard error, where the process ends otherwise, and where the system has none to give.
nlohmann::ordered_json in_own_process(const std::string& name,
                                      const std::function<nlohmann::ordered_json()>& work);

}  // namespace desmo::bench
