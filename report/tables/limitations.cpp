// What a reader must not conclude: fixed sentences, each shown where it is true of the record.
#include <algorithm>

#include "report/statistics/measurements.h"
#include "report/tables/tables.h"

namespace desmo::report {
namespace {

bool has_papers_own(const Record& record) {
  return std::ranges::count(recorded_families(record), papers_own) > 0;
}

bool is_unsteady(const Machine& machine) {
  const bool busy = !machine.load_before.empty() &&
                    machine.load_before.front() > 0.5 * static_cast<double>(machine.cores);
  return busy || machine.governor.empty() || machine.governor == "unknown";
}

}  // namespace

Section limitations(const Record& record) {
  Section section{"Known limitations", {}, {}};
  const auto say = [&section](bool holds, const std::string& sentence) {
    if (holds) section.paragraphs.push_back(sentence);
  };
  const Sources source = sources(record);
  say(!has_papers_own(record),
      "The paper's sparse solver, MA27, cannot be redistributed; cholmod, umfpack and klu stand "
      "for it, each in every role it has in the paper.");
  say(has_papers_own(record),
      "MA27 solves normal equations here: the paper does not say how its equations become "
      "symmetric.");
  say(true,
      "The paper prints no dimensions, no motion and no time step for the truck suspension; the "
      "ones here reproduce all its counts and are this suite's own.");
  say(true,
      "Seconds of two machines do not compare, and speed-ups of one machine need not be those of "
      "another: caches and vector units differ.");
  say(true,
      "Intervals say what the repetitions of one run vary by, not what differs from run to run and "
      "from build to build.");
  say(true,
      "Errors are those at the instants compared; near a singular position a small residual does "
      "not mean a small error.");
  say(is_unsteady(record.machine),
      "The machine may not have been steady: its frequency governor is unknown, or it was not idle "
      "when the run began.");
  say(record.dirty,
      "The program was built with changes that its commit does not have: the run cannot be "
      "repeated from the commit alone.");
  say(has_paper(record) && !source.warning.empty(), source.warning);
  return section;
}

}  // namespace desmo::report
