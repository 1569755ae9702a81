// Handling of SIGINT, SIGTERM and SIGHUP. They end the program, and a compiler that it runs, at
// once, and leave no unfinished file.
#pragma once

#include <string>

namespace desmo::cli {

/// Installs the signal handlers. A signal that was ignored from the start (nohup) stays ignored.
/// Writes to a closed pipe or beyond a size limit report errors themselves.
void handle_signals();

/// Lets an interruption remove the file of that name, in place of the one named before.
void remove_when_interrupted(const std::string& path);

}  // namespace desmo::cli
