// What a reader must not conclude: what holds of every record, and what this one lacks.
#include <algorithm>

#include "report/digits.h"
#include "report/measurements.h"
#include "report/paper.h"
#include "report/tables/tables.h"
#include "report/time_words.h"

namespace desmo::report {
namespace {

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

bool has_papers_own(const Record& record) {
  return std::ranges::count(recorded_families(record), papers_own) > 0;
}

std::string of_the_papers_solver(const Record& record) {
  if (!has_papers_own(record))
    return "The paper's sparse solver, MA27, cannot be redistributed; cholmod, umfpack and klu "
           "stand for it, each in every role it has in the paper.";
  const auto library = record.libraries.find(std::string(papers_own));
  return "MA27, the paper's sparse solver, was measured from a library of the user's" +
         (library == record.libraries.end() ? std::string() : ", " + library->second) +
         ", on normal equations: the paper does not say how it makes its equations symmetric for "
         "it. It cannot be redistributed; cholmod, umfpack and klu stand for it beside it.";
}

std::string intervals_of(const Record& record) {
  if (has_samples_of_windows(record))
    return "The intervals of speed-ups hold what leaving out one repetition changes: they are "
           "narrow "
           "where several repetitions were undisturbed for a while, and say nothing of what "
           "disturbed all of them throughout.";
  if (record.settings.windows)
    return "The intervals of speed-ups hold what differs from piece to piece of the motion in "
           "one run, with a probability of 95 %.";
  return "The intervals hold what the repetitions of one run vary by, with a probability that "
         "follows from their number.";
}

void add_of_the_machine(const Record& record, std::vector<std::string>& lines) {
  const Machine& machine = record.machine;
  if (machine.governor.empty() || machine.governor == "unknown")
    lines.push_back(
        "The frequency governor of this machine is unknown: its clock may have changed during the "
        "run.");
  const auto busy = [&](const std::vector<double>& load) {
    return !load.empty() && load.front() > 0.5 * static_cast<double>(machine.cores);
  };
  if (busy(machine.load_before))
    lines.push_back("The machine was not idle when the run began: its load was " +
                    write_fixed(machine.load_before.front(), 2) + " on " +
                    counted(static_cast<std::size_t>(machine.cores), "core") + ".");
  if (record.dirty)
    lines.push_back(
        "The program was built with changes that its commit does not have: the run cannot be "
        "repeated from the commit alone.");
}

void add_of_the_cells(const Record& record, std::vector<std::string>& lines) {
  const std::size_t left_out = static_cast<std::size_t>(
      std::count_if(record.cells.begin(), record.cells.end(),
                    [](const auto& cell) { return cell.second.status == Status::not_run; }));
  if (left_out > 0)
    lines.push_back(counted(left_out, "cell") + (left_out == 1 ? " was" : " were") +
                    " left out on purpose; the tables of every formulation say why.");
  const std::size_t standing_in = recorded_families(record).size() - has_papers_own(record);
  if (standing_in < stand_ins.size())
    lines.push_back("Only " + std::to_string(standing_in) + " of " +
                    counted(stand_ins.size(), "sparse solver") + " stand in this record.");
  if (const Sources source = sources(record); !source.warning.empty())
    lines.push_back(source.warning);
}

}  // namespace

Section limitations(const Record& record) {
  std::vector<std::string> lines{
      of_the_papers_solver(record),
      "The paper prints no dimensions, no motion and no time step for the truck suspension; the "
      "ones here reproduce all its counts and are this suite's own.",
      "Seconds of two machines do not compare. Speed-ups of one machine need not be those of "
      "another: caches and vector units differ."};
  if (has_cells(record)) {
    lines.push_back(intervals_of(record) +
                    " They do not hold what differs from run to run and from build to build.");
    lines.push_back(
        "An accepted position has a small residual; near singular positions that does not mean a "
        "small error. Every time shown is of a formulation that agrees with the "
        "quadruple-precision reference at the instants verified.");
  }
  if (!record.points.empty() || !record.tuning.empty()) {
    lines.push_back(
        "Times of a step in sections on accuracy are the least of a few samples; the second least "
        "says how well they can be had again in the same run, not in another run or build.");
    lines.push_back(
        "Errors are those at the instants compared, a few of a short motion; another motion, "
        "nearer to a singular position, has others.");
  }
  if (has_sizes(record))
    lines.push_back(
        "Times at different sizes were taken one after the other: what the machine did for minutes "
        "meets some sizes and not others.");
  add_of_the_machine(record, lines);
  if (has_cells(record)) add_of_the_cells(record, lines);
  return {"Known limitations", std::move(lines), {}};
}

}  // namespace desmo::report
