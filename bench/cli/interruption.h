// Handling of SIGINT, SIGTERM and SIGHUP. They end the program, and a compiler that it runs, at
// once, and remove the unfinished file that remove_when_interrupted() names.
#pragma once

#include <string>

namespace desmo::cli {

/// Installs the signal handlers. A signal that was ignored from the start (nohup) stays ignored.
/// Ignores SIGPIPE and SIGXFSZ: writes to a closed pipe or beyond a size limit then return errors.
void handle_signals();

/// Lets an interruption remove the file of that name, in place of the one named before.
void remove_when_interrupted(const std::string& path);

}  // namespace desmo::cli
