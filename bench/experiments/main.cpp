// desmo_bench [EXPERIMENT] [OPTION...]: runs an experiment, the paper's where there are options but
// no name. Without arguments it lists the experiments.

#include <unistd.h>

#include <exception>
#include <iostream>
#include <regex>
#include <stdexcept>
#include <string>
#include <string_view>

#include "bench/experiments/experiments.h"
#include "bench/kit/memory.h"
#include "bench/kit/record/environment.h"
#include "cases/io/input_error.h"
#include "cases/io/text_file.h"
#include "cases/mechanism/names.h"
#include "formulations/algebra/blas.h"

namespace {

using namespace desmo::bench;

using RunFunction = ExitCode(const CommandLine&);

// Run functions of the experiments that need more generated code than that of the cases. Only
// desmo_bench_all has them.
#ifdef DESMO_ALL_EXPERIMENTS
constexpr RunFunction *run_modelling = desmo::modelling::run, *run_extremes = desmo::extremes::run;
#else
constexpr RunFunction *run_modelling = nullptr, *run_extremes = nullptr;
#endif

struct Experiment {
  std::string_view name, help;
  RunFunction* run;  ///< null: desmo_bench_all has it
};

/// The table of experiments, the paper's first.
constexpr Experiment all_experiments[] = {
    {"paper", "CPU time of every case, size and formulation: the paper's Tables 1 and 2",
     desmo::paper::run},
    {"accuracy", "Time against error of formulations and their settings", desmo::accuracy::run},
    {"size", "How time grows with the size of a mechanism", desmo::size::run},
    {"modelling", "The paper's comparison in each kind of coordinates", run_modelling},
    {"instructions", "Instructions a step, counted by callgrind", desmo::instructions::run},
    {"extremes", "Every formulation where most go wrong", run_extremes},
};

void print_experiments() {
  std::cout << "desmo_bench [EXPERIMENT] [OPTION...]: measures, and writes a record. Experiments:\n"
               "\n";
  for (const Experiment& e : all_experiments) {
    std::string name(e.name);
    name.resize(14, ' ');
    std::cout << "  " << name << e.help << '\n';
  }
  std::cout << "\ndesmo_bench EXPERIMENT --help lists an experiment's options; --version says which"
               "\nversion this is. With options and no experiment it is the paper's.\n\n";
}

/// Goes on as desmo_bench_all. Throws std::runtime_error where that is not built.
[[noreturn]] void become_desmo_bench_all(char** argv) {
  const std::string program = beside_this_program("desmo_bench_all");
  ::execv(program.c_str(), argv);
  throw std::runtime_error(program + " cannot be started; bench/run builds it");
}

ExitCode run(int argc, char** argv) {
  const std::string_view first = argc > 1 ? argv[1] : "";
  if (first == "--version") {
    std::cout << "desmo_bench " DESMO_VERSION "\n";
    return success;
  }
  const bool has_name = argc > 1 && !first.starts_with('-');
  if (argc < 2 || first == "--help" || first == "-h") print_experiments();
  if (argc < 2) return success;
  const Experiment& experiment =
      has_name ? desmo::entry_named(first, all_experiments, "experiment") : all_experiments[0];
  if (!experiment.run) become_desmo_bench_all(argv);
  keep_freed_memory();
  desmo::set_blas_threads(1);  // Clock::cpu counts this thread alone
  return experiment.run({std::string(experiment.name),
                         command_line(argc, argv),
                         argv[0],
                         {argv + (has_name ? 2 : 1), argv + argc}});
}

}  // namespace

int main(int argc, char** argv) {
  const auto failed = [](const std::string& message, ExitCode code) {
    std::cerr << "desmo_bench: " << message << '\n';
    return code;
  };
  try {
    return run(argc, argv);
  } catch (const std::regex_error& error) {
    return failed(std::string("not a regular expression: ") + error.what(), usage_error);
  } catch (const std::invalid_argument& error) {
    return failed(error.what(), usage_error);
  } catch (const desmo::InputError& error) {
    return failed(error.what(), bad_input);
  } catch (const desmo::UnreadableFile& error) {
    return failed(error.what(), unreadable_input);
  } catch (const std::exception& error) {
    return failed(error.what(), not_completed);
  }
}
