#include "bench/experiments/paper/options.h"

#include <charconv>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "cases/cases.h"

namespace desmo::suite {

namespace {

template <class Number>
Number positive(std::string_view option, std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !(value > 0) ||
      !std::isfinite(static_cast<double>(value)))
    throw std::invalid_argument(std::string(option) + ": '" + std::string(text) +
                                "' is not a positive number");
  return value;
}

}  // namespace

const char* const usage =
    "desmo_bench: verifies, then times, every case, size and formulation.\n"
    "A benchmark is named <case>/<coordinates>/<id>; one iteration is the whole analysis.\n"
    "<case>/<coordinates>/<id>/request:<name> solves only what that request needs.\n"
    "<case>/<coordinates>/peer:<name> is solved by a rival: by hand, or, where built "
    "(DESMO_PEERS),\n"
    "by a library.\n\n"
    "  --step=SECONDS           time step (default: the case's, 0.01)\n"
    "  --duration=SECONDS       motion analysed (default: the case's, 30)\n"
    "  --dense-limit=N          coordinates up to which dense global solves run (default 114)\n"
    "  --slow-limit=N           coordinates up to which SPQR, and UMFPACK and SparseLU in blocks,\n"
    "                           run (default 114)\n"
    "  --peer-limit=SECONDS     CPU time a rival may take for the motion (default 60)\n"
    "  --formulation=ID         adds a formulation with settings as suffixes, such as\n"
    "                           global_automatic_klu/guess:hermite5; may be given more than once\n"
    "  --record=FILE            write the results record (see results/README.md)\n\n"
    "Exit code: 0 all verified and timed; 1 some formulation failed; 64 usage, or no benchmark\n"
    "matches; 74 the record could not be written. Flags of Google Benchmark (repetitions,\n"
    "in random order, default to as many as take 2.5 s together, 3 to 20):\n\n";

Options take_options(std::vector<char*>& arguments) {
  Options o;
  using Setter = std::function<void(std::string_view, std::string_view)>;
  const auto real = [](double& target) -> Setter {
    return [&](auto name, auto text) { target = positive<double>(name, text); };
  };
  const auto whole = [](int& target) -> Setter {
    return [&](auto name, auto text) { target = positive<int>(name, text); };
  };
  const std::pair<std::string_view, Setter> table[] = {
      {"--step", real(o.step)},
      {"--duration", real(o.duration)},
      {"--dense-limit", whole(o.dense_limit)},
      {"--slow-limit", whole(o.slow_limit)},
      {"--peer-limit", real(o.peer_limit)},
      {"--formulation", [&](auto, auto text) { o.formulations.emplace_back(text); }},
      {"--record", [&](auto, auto text) { o.record = text; }},
  };

  std::vector<char*> rest;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string_view argument = arguments[i];
    const std::string_view name = argument.substr(0, argument.find('='));
    const Setter* setter = nullptr;
    for (const auto& [option, set] : table)
      if (name == option) setter = &set;
    if (argument == "--help" || argument == "-h") {
      o.help = true;
    } else if (!setter) {
      rest.push_back(arguments[i]);
    } else if (name.size() < argument.size()) {
      (*setter)(name, argument.substr(name.size() + 1));
    } else if (i + 1 < arguments.size()) {
      (*setter)(name, arguments[++i]);
    } else {
      throw std::invalid_argument(std::string(name) + ": a value is missing");
    }
  }
  arguments = std::move(rest);
  return o;
}

TimeGrid chosen_grid(const TimeGrid& own, const Options& o) {
  const double duration = own.time(own.instants - 1) - own.start;
  return time_grid(o.duration > 0 ? o.duration : duration, o.step > 0 ? o.step : own.step);
}

}  // namespace desmo::suite
