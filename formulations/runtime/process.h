// Functions to start another process and to wait for its end.
#pragma once

#include <sys/types.h>
#include <sys/wait.h>

#include <cerrno>
#include <string>
#include <vector>

namespace desmo::load {

/// Returns arguments or an environment as new programs get them: a pointer to each text, then null.
/// The texts must outlive the pointers.
inline std::vector<char*> null_terminated(const std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (const std::string& text : texts) result.push_back(const_cast<char*>(text.c_str()));
  result.push_back(nullptr);
  return result;
}

/// Waits until a child process has ended, through interruptions by signals. Returns false, with
/// errno, when it cannot be waited for. status: receives the exit status of waitpid(); unchanged
/// when the result is false.
inline bool wait_for_end(pid_t child, int& status) {
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return false;
  return true;
}

}  // namespace desmo::load
