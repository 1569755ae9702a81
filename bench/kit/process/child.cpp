#include "bench/kit/process/child.h"

#include <fcntl.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "formulations/algebra/coinhsl.h"
#include "formulations/runtime/descriptor.h"
#include "formulations/runtime/process.h"

namespace desmo::bench {

namespace {

/// Returns a copy of a file in memory. It has no name and lasts as long as it is open.
load::Descriptor copy_of(const char* path) {
  const load::Descriptor from(open(path, O_RDONLY | O_CLOEXEC));
  load::Descriptor copy(memfd_create(path, MFD_CLOEXEC));
  struct stat status {};
  bool good = from.is_open() && copy.is_open() && fstat(from.number(), &status) == 0;
  for (off_t done = 0; good && done < status.st_size;)
    good = sendfile(copy.number(), from.number(), &done,
                    static_cast<std::size_t>(status.st_size - done)) > 0;
  if (!good)
    throw std::runtime_error(std::string(path) + " cannot be copied: " + std::strerror(errno));
  return copy;
}

/// Turns the new process into the program. Calls only functions that are safe between fork and
/// exec.
[[noreturn]] void become(int core, int program, int in, int out, char* const* arguments,
                         char* const* variables) {
  if (core >= 0) {
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(core, &one);
    sched_setaffinity(0, sizeof one, &one);
  }
  dup2(in, STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  if (program >= 0)
    fexecve(program, arguments, variables);
  else
    execve(arguments[0], arguments, variables);
  _exit(127);
}

}  // namespace

Launch fixed_launch(std::vector<std::string> arguments) {
  Launch launch{
      std::move(arguments),
      {"LC_ALL=C", "LD_BIND_NOW=1", "OPENBLAS_NUM_THREADS=1", "PATH=/usr/local/bin:/usr/bin:/bin"}};
  for (const char* name : {"LD_LIBRARY_PATH", coinhsl_variable})
    if (const char* libraries = std::getenv(name))
      launch.environment.push_back(std::string(name) + "=" + libraries);
  return launch;
}

Child::Child(const Launch& launch) : program_(launch.arguments[0]) {
  const load::Descriptor copy =
      launch.fresh_copy ? copy_of(launch.arguments[0].c_str()) : load::Descriptor();
  load::Pipe questions, answers;
  const std::vector<char*> arguments = load::null_terminated(launch.arguments);
  const std::vector<char*> variables = load::null_terminated(launch.environment);
  process_ = fork();
  if (process_ < 0) throw std::runtime_error(program_ + " cannot be started");
  if (process_ == 0)
    become(launch.core, copy.number(), questions.read_end.number(), answers.write_end.number(),
           arguments.data(), variables.data());
  in_ = fdopen(questions.write_end.release(), "w");
  out_ = fdopen(answers.read_end.release(), "r");
}

Child::~Child() {
  if (in_) std::fclose(in_);
  if (out_) std::fclose(out_);
  int unused = 0;
  if (process_ > 0) load::wait_for_end(process_, unused);
}

void Child::say(std::string_view line) {
  std::fwrite(line.data(), 1, line.size(), in_);
  std::fputc('\n', in_);
  if (std::fflush(in_) != 0) throw std::runtime_error(program_ + " has ended early");
}

std::string Child::read_answer() {
  char* line = nullptr;
  std::size_t size = 0;
  const ssize_t length = getline(&line, &size, out_);
  std::string text(line ? line : "", length > 0 ? static_cast<std::size_t>(length) : 0);
  std::free(line);
  if (length <= 0) throw std::runtime_error(program_ + " has ended early");
  if (text.back() == '\n') text.pop_back();
  return text;
}

int Child::finish(std::string& output) {
  std::fclose(in_);
  in_ = nullptr;
  output.clear();
  std::array<char, 4096> buffer;
  for (std::size_t n; (n = std::fread(buffer.data(), 1, buffer.size(), out_)) > 0;)
    output.append(buffer.data(), n);
  int status = 0;
  if (!load::wait_for_end(std::exchange(process_, -1), status))
    throw std::runtime_error("lost the process of " + program_ + ": " + std::strerror(errno));
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::vector<int> usable_cores() {
  cpu_set_t set;
  CPU_ZERO(&set);
  std::vector<int> cores;
  if (sched_getaffinity(0, sizeof set, &set) == 0)
    for (int core = 0; core < CPU_SETSIZE; ++core)
      if (CPU_ISSET(core, &set)) cores.push_back(core);
  return cores;
}

}  // namespace desmo::bench
