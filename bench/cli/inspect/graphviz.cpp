#include "bench/cli/inspect/graphviz.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "bench/cli/errors.h"
#include "formulations/runtime/file_actions.h"

extern char** environ;

namespace desmo::cli {
namespace {

using File = std::unique_ptr<std::FILE, decltype([](std::FILE* f) { std::fclose(f); })>;

/// A file without a name: unlike a pipe, it needs nobody to feed it while dot runs.
File holding(const std::string& text) {
  File file(std::tmpfile());
  if (!file || std::fwrite(text.data(), 1, text.size(), file.get()) != text.size() ||
      std::fflush(file.get()) != 0 || ::lseek(::fileno(file.get()), 0, SEEK_SET) != 0)
    throw Error(unwritable_output, std::string("a temporary file cannot be written (") +
                                       std::strerror(errno) + "); make room in /tmp");
  return file;
}

}  // namespace

void draw_svg(const std::string& graph, Output& output) {
  const File input = holding(graph);
  load::FileActions actions;
  ::posix_spawn_file_actions_adddup2(&actions.list, ::fileno(input.get()), STDIN_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions.list, output.descriptor(), STDOUT_FILENO);
  char program[] = "dot", format[] = "-Tsvg";
  char* const arguments[] = {program, format, nullptr};
  pid_t child = 0;
  const int error = ::posix_spawnp(&child, program, &actions.list, nullptr, arguments, environ);
  if (error != 0)
    throw Error(unavailable, std::string("the program 'dot' cannot be run (") +
                                 std::strerror(error) +
                                 "); install Graphviz (Debian: apt-get install graphviz), or let "
                                 "--diagram write a .dot file");
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) throw Error(unavailable, "the end of 'dot' cannot be awaited; try again");
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw Error(unavailable,
                "'dot' has failed; let --diagram write a .dot file and draw that by other means");
}

}  // namespace desmo::cli
