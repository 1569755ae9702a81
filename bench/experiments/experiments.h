#pragma once

#include "bench/experiments/options.h"
#include "bench/kit/exit_codes.h"

// The experiments: experiments/NAME/run.cpp defines run() of namespace NAME. Each measures, and
// returns success, or not_solved where something that was measured is wrong. Throws
// std::invalid_argument and std::regex_error for a mistake in the command line, UnreadableFile and
// InputError for a scene, any other exception where something cannot be measured or written.

namespace desmo::paper {
bench::ExitCode run(const bench::CommandLine& line);
}
namespace desmo::accuracy {
bench::ExitCode run(const bench::CommandLine& line);
}
namespace desmo::size {
bench::ExitCode run(const bench::CommandLine& line);
}
namespace desmo::modelling {
bench::ExitCode run(const bench::CommandLine& line);
}
namespace desmo::instructions {
bench::ExitCode run(const bench::CommandLine& line);
}
namespace desmo::extremes {
bench::ExitCode run(const bench::CommandLine& line);
}
