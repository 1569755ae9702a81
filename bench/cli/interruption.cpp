#include "bench/cli/interruption.h"

#include <unistd.h>

#include <atomic>
#include <climits>
#include <csignal>
#include <cstring>

#include "formulations/runtime/program.h"

namespace desmo::cli {
namespace {

// Memory that the signal handler reads. It is plain and static: a handler may not use the heap, and
// may run after destructors of static objects.
char path_to_remove[PATH_MAX];
std::atomic<bool> is_to_be_removed{false};
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void end_now(int signal) {
  load::end_running_program();
  if (is_to_be_removed) ::unlink(path_to_remove);
  ::_exit(128 + signal);
}

}  // namespace

void handle_signals() {
  struct sigaction action = {};
  action.sa_handler = end_now;
  for (const int s : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction inherited = {};
    if (::sigaction(s, nullptr, &inherited) == 0 && inherited.sa_handler != SIG_IGN)
      ::sigaction(s, &action, nullptr);
  }
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

void remove_when_interrupted(const std::string& path) {
  is_to_be_removed = false;
  if (path.size() >= sizeof path_to_remove) return;  // the system makes no file of such a name
  std::memcpy(path_to_remove, path.c_str(), path.size() + 1);
  is_to_be_removed = true;
}

}  // namespace desmo::cli
