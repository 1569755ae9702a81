#include "bench/experiments/extremes/known_case.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <iterator>
#include <random>
#include <span>
#include <stdexcept>
#include <utility>

#include "bench/experiments/extremes/chain_solution.h"
#include "formulations/verification/condition.h"
#include "formulations/verification/reference/reference.h"

namespace desmo::extremes {

namespace {

/// Returns the relative errors that conditioning allows in double precision at positions q:
/// accuracy_limit() times the magnitude of the largest driver, since its own rounding cannot be
/// undone. That magnitude is in rad, or a length divided by the nominal size; at least 1.
PerLevel<double> floor_at(const Model& m, std::span<const double> q, double condition) {
  const double size = nominal_size(m);
  double driven = 1;
  for (const Driver& d : m.drivers) {
    const Entity& e = m.entities[d.coordinate];
    driven = std::max(driven, std::abs(q[e.first]) / (is_length(e.kind) ? size : 1));
  }
  PerLevel<double> floor = accuracy_limit(std::max(1.0, condition), std::ldexp(1, -53));
  for (const Level level : all_levels) floor[level] *= driven;
  return floor;
}

/// Adds condition, floors and scales to answers.
/// - conditions: condition number of each answer by a closed form, which knows better than the
///   equations how far a long chain passes an error on; empty: those of the equations
///   (ConditionNumber)
/// - motion: instants from which the scales are made; empty: from the answers
void add_floors(Answers& a, const std::vector<double>& conditions,
                std::vector<ReferenceInstant> motion = {}) {
  std::optional<ConditionNumber> number;
  if (conditions.empty()) number.emplace(a.model);
  for (std::size_t i = 0; i < a.right.size(); ++i) {
    PerLevel<double>& floor = a.floor.emplace_back();
    const ReferenceInstant& right = a.right[i];
    if (right.q.empty()) continue;
    const double condition = number ? (*number)(right.q) : conditions[i];
    floor = floor_at(a.model, right.q, condition);
    a.condition = std::max(a.condition, condition);
  }
  if (motion.empty())
    std::ranges::copy_if(a.right, std::back_inserter(motion),
                         [](const ReferenceInstant& r) { return !r.q.empty(); });
  a.scales = make_scales(a.model, motion);
}

/// Returns answers without any instant for a part of the case's mechanism, or for all of it: the
/// model and the coordinates alone.
Answers answers_of(Model part, const KnownCase& known) {
  const Model& whole = known.modelled->model;
  Answers a{.model = std::move(part)};
  a.coordinate.resize(a.model.coordinates());
  for (const Entity& e : a.model.entities)
    for (int i = 0; !e.fixed && i < e.size; ++i)
      a.coordinate[e.first + i] = whole.entities[whole.find(e.name)].first + i;
  return a;
}

double max_link(const DyadChain& chain) {
  double longest = chain.crank;
  for (const DyadChain::Dyad& d : chain.dyads) longest = std::max({longest, d.coupler, d.rocker});
  return longest;
}

/// Returns the model of one of the case's chains alone.
Model alone(const KnownCase& known, std::size_t index) {
  const ExtremeCase& c = *known.definition;
  if (c.chains.size() == 1) return known.modelled->model;
  MechanismBuilder builder(c.scene.mechanism.name, 2);
  builder.set_length_unit(c.scene.mechanism.length_unit);
  add(builder, c.chains[index]);
  return model_mechanism(builder.release(), {c.scene.motions[index]}).model;
}

/// Returns the time [s], to its last bit, at which a chain's answers end or begin. It has an answer
/// at exactly one of the times `from` and `to`.
double end_between(ChainSolution& solution, double from, double to) {
  const bool known = solution.solve(from);
  for (;;) {
    const double middle = from + (to - from) / 2;
    if (middle <= from || middle >= to) return middle;
    (solution.solve(middle) == known ? from : to) = middle;
  }
}

/// Returns the answers of the case's chain of that index, by the closed form. Sets `solvable` to
/// false at instants where the chain has none. Adds to `ends` the times at which answers end or
/// begin.
Answers chain_answers(KnownCase& known, std::size_t index) {
  const ExtremeCase& c = *known.definition;
  const DyadChain& chain = c.chains[index];
  Answers a = answers_of(alone(known, index), known);
  const double size = nominal_size(a.model), longest = max_link(chain);
  const std::size_t links = std::max<std::size_t>(1, chain.dyads.size());
  a.chain_length = longest * static_cast<double>(links) / size;
  ChainSolution solution(chain, a.model);
  std::vector<double> conditions;
  std::vector<ReferenceInstant> motion;  // with Bound::estimates: all instants, else empty
  std::size_t next = 0;
  bool before = true;
  for (std::size_t i = 0; i < known.solvable.size(); ++i) {
    const double t = c.scene.grid.time(static_cast<int>(i));
    const bool solved = solution.solve(t);
    if (i > 0 && solved != before) {
      known.ends.push_back(end_between(solution, c.scene.grid.time(static_cast<int>(i) - 1), t));
      solution.solve(t);
    }
    before = solved;
    if (!solved) known.solvable[i] = false;
    if (solved && c.bound == Bound::estimates) motion.push_back(solution.instant());
    if (next == known.compared.size() || known.compared[next] != static_cast<int>(i)) continue;
    ++next;
    a.right.push_back(solved ? solution.instant() : ReferenceInstant{t, {}, {}, {}});
    if (c.bound == Bound::length) conditions.push_back(solution.condition());
  }
  add_floors(a, conditions, std::move(motion));
  // An angle's error counts as the distance by which it moves the end of the longest link, divided
  // by the size. Long chains would otherwise allow it less than what rounding that point causes.
  if (c.bound == Bound::length) a.scales.rotation.position = size / longest;
  return a;
}

/// Returns the answers of the whole mechanism by make_reference(). Throws std::runtime_error where
/// its two solutions do not converge or differ by 1e-20 or more.
Answers reference_answers(const KnownCase& known) {
  const ExtremeCase& c = *known.definition;
  Answers a = answers_of(known.modelled->model, known);
  std::vector<double> times;
  for (const int i : known.compared)
    if (known.solvable[i]) times.push_back(c.scene.grid.time(i));
  const Reference reference = make_reference(a.model, times);
  if (!(reference.floor.position < 1e-20))
    throw std::runtime_error("the two references differ by more than 1e-20");
  a.right = reference.instants;
  a.right.resize(known.compared.size(), {c.scene.grid.time(known.compared.back()), {}, {}, {}});
  add_floors(a, {});
  return a;
}

/// Returns the answer of each start, on the branch to which the references lead from it; without q
/// where they do not converge or do not agree.
Answers answers_to_starts(const KnownCase& known) {
  Answers a = answers_of(known.modelled->model, known);
  const double time = known.definition->scene.grid.time(0);
  Model started = a.model;
  for (const int i : known.compared) {
    started.estimate = known.starts[i];
    ReferenceInstant& right = a.right.emplace_back(ReferenceInstant{time, {}, {}, {}});
    try {
      const Reference reference = make_reference(started, {&time, 1});
      if (reference.floor.position < 1e-20) right = reference.instants.front();
    } catch (const std::runtime_error&) {  // no answer
    }
  }
  add_floors(a, {});
  return a;
}

/// Returns estimates of a mechanism's positions. Coordinates that are not driven are off by up to
/// starts.off times their nominal magnitudes, evenly distributed, the same in every run.
std::vector<std::vector<double>> make_starts(const Model& m, const ExtremeCase::Starts& starts) {
  const std::vector<double> magnitude = nominal_magnitudes(m);
  const std::vector<bool> driven = independent_coordinates(m);
  std::mt19937_64 bits(1);
  // No std distribution, since each library has its own. Returns a number from -1 to 1.
  const auto even = [&] { return std::ldexp(static_cast<double>(bits() >> 11), -52) - 1; };
  std::vector<std::vector<double>> all(starts.count, m.estimate);
  for (std::vector<double>& estimate : all)
    for (int i = 0; i < m.coordinates(); ++i)
      if (!driven[i]) estimate[i] += starts.off * magnitude[i] * even();
  return all;
}

constexpr int spread_instants = 201;  // largest number of compared instants (≤) that are spread

std::vector<int> compared_instants(const ExtremeCase& c) {
  const int count = c.starts ? c.starts->count : c.scene.grid.instants;
  std::vector<int> all;
  if (const int ends = c.compared_at_ends; ends > 0) {
    for (int i = 0; i < ends; ++i) all.push_back(i);
    for (int i = count - ends; i < count; ++i) all.push_back(i);
    return all;
  }
  const int compared = c.starts ? count : std::min(count, spread_instants);
  for (int i = 0; i < compared; ++i)
    all.push_back(
        compared == 1 ? 0 : static_cast<int>(static_cast<long>(i) * (count - 1) / (compared - 1)));
  return all;
}

}  // namespace

double KnownCase::condition() const {
  double largest = 0;
  for (const Answers& a : answers) largest = std::max(largest, a.condition);
  return largest;
}

KnownCase make_known_case(const ExtremeCase& c) {
  KnownCase known{.definition = &c, .compared = compared_instants(c)};
  known.solvable.assign(c.starts ? c.starts->count : c.scene.grid.instants, true);
  if (c.ends_singular) known.solvable.back() = false;
  try {
    known.modelled = model_mechanism(c.scene.mechanism, c.scene.motions);
  } catch (const std::invalid_argument& error) {
    known.refusal = error.what();
    return known;
  }
  if (c.starts) known.starts = make_starts(known.modelled->model, *c.starts);
  if (c.is_refused) return known;  // a refused case has no answers
  try {
    if (c.starts)
      known.answers.push_back(answers_to_starts(known));
    else
      for (std::size_t i = 0; i < c.chains.size(); ++i)
        known.answers.push_back(chain_answers(known, i));
    if (!c.starts && c.chains.empty() && known.modelled->model.coordinates() > 0)
      known.answers.push_back(reference_answers(known));
  } catch (const std::exception& error) {
    known.no_answer = error.what();
    known.answers.clear();
  }
  return known;
}

}  // namespace desmo::extremes
