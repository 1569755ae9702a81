#include "formulations/runtime/program.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <system_error>

#include "formulations/runtime/descriptor.h"
#include "formulations/runtime/process.h"

namespace desmo::load {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t max_output = std::size_t{1} << 16;  // length of ProgramEnd::output [bytes]

// The process of the running child, which leads a process group of the same number; 0: none.
std::atomic<pid_t> running{0};
static_assert(std::atomic<pid_t>::is_always_lock_free);

std::vector<std::string> environment() {
  std::vector<std::string> variables{"LC_ALL=C"};
  for (const char* name : {"PATH", "HOME", "TMPDIR"})
    if (const char* value = std::getenv(name)) variables.push_back(std::string(name) + "=" + value);
  return variables;
}

/// Gives a program its own process group, so that all processes it starts can be ended with it.
/// Gives it the default signal handling, with no signal blocked.
void set_attributes(posix_spawnattr_t& attributes) {
  sigset_t none, all;
  ::sigemptyset(&none);
  ::sigfillset(&all);
  ::posix_spawnattr_setpgroup(&attributes, 0);
  ::posix_spawnattr_setsigmask(&attributes, &none);
  ::posix_spawnattr_setsigdefault(&attributes, &all);
  ::posix_spawnattr_setflags(
      &attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
}

/// Starts a program and assigns its process to `running`. Blocks interrupting signals in this
/// thread until then: a signal between start and assignment would not end the program.
pid_t start(const std::vector<std::string>& arguments, int folder, int output) {
  const std::vector<std::string> variables = environment();
  const std::vector<char*> argv = null_terminated(arguments), envp = null_terminated(variables);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  // First: where our standard streams are closed, the folder's descriptor may have their numbers.
  ::posix_spawn_file_actions_addfchdir_np(&actions, folder);
  ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  ::posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, output, STDERR_FILENO);
  posix_spawnattr_t attributes;
  ::posix_spawnattr_init(&attributes);
  set_attributes(attributes);
  sigset_t interruptions, old_mask;
  ::sigemptyset(&interruptions);
  for (const int s : {SIGINT, SIGTERM, SIGHUP}) ::sigaddset(&interruptions, s);

  pid_t child = 0;
  ::pthread_sigmask(SIG_BLOCK, &interruptions, &old_mask);
  const int error =
      ::posix_spawn(&child, arguments[0].c_str(), &actions, &attributes, argv.data(), envp.data());
  if (error == 0) running = child;
  ::pthread_sigmask(SIG_SETMASK, &old_mask, nullptr);
  ::posix_spawnattr_destroy(&attributes);
  ::posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw std::system_error(error, std::generic_category(), arguments[0]);
  return child;
}

/// Returns the milliseconds until a time, rounded up; 0 when it is over.
int remaining(Clock::time_point end) {
  const auto time = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now());
  return static_cast<int>(std::max<std::chrono::milliseconds::rep>(time.count(), 0));
}

/// Reads until all writers have closed the other end. Keeps the first max_output bytes. Returns
/// false when the time is over.
bool read_all(int from, Clock::time_point end, std::string& text) {
  std::array<char, 4096> buffer;
  for (;;) {
    pollfd wanted{from, POLLIN, 0};
    const int ready = ::poll(&wanted, 1, remaining(end));
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) return false;
    const ssize_t size = ::read(from, buffer.data(), buffer.size());
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return true;
    text.append(buffer.data(), std::min(static_cast<std::size_t>(size), max_output - text.size()));
  }
}

/// Waits for a child until `end`. Returns whether it has ended. status: receives its exit status;
/// unchanged where SIGCHLD is ignored.
bool wait_until(pid_t child, Clock::time_point end, int& status) {
  constexpr int pause = 2;  // between two looks [ms]
  for (;;) {
    const pid_t ended = ::waitpid(child, &status, WNOHANG);
    // Where SIGCHLD is ignored, waitpid() fails after the child's end, and its exit code is lost.
    // Callers see from what the child has written whether it succeeded.
    if (ended == child || (ended < 0 && errno == ECHILD)) return true;
    const int left = remaining(end);
    if (left == 0) return false;
    ::poll(nullptr, 0, std::min(pause, left));
  }
}

}  // namespace

ProgramEnd run_program(const std::vector<std::string>& arguments, int folder,
                       std::chrono::milliseconds time) {
  Pipe pipe;
  const Clock::time_point end = Clock::now() + time;
  const pid_t child = start(arguments, folder, pipe.write_end.number());
  pipe.write_end = Descriptor();

  ProgramEnd ending;
  int status = 0;
  ending.late =
      !read_all(pipe.read_end.number(), end, ending.output) || !wait_until(child, end, status);
  if (ending.late) {
    ::kill(-child, SIGKILL);
    wait_for_end(child, status);
  }
  running = 0;
  ending.good = !ending.late && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  return ending;
}

void end_running_program() noexcept {
  if (const pid_t group = running; group > 0) ::kill(-group, SIGTERM);
}

}  // namespace desmo::load
