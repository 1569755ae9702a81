#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>

#include "bench/experiments/extremes/chain_solution.h"
#include "bench/experiments/extremes/known_case.h"
#include "formulations/verification/condition.h"
#include "formulations/verification/reference/reference.h"

namespace desmo::extremes {

namespace {

/// Returns the error that conditioning lets double precision reach in a position, relative to
/// natural magnitudes: accuracy_limit, for as many units of roundoff as the largest driver has
/// turns of 1 rad, or lengths of the mechanism's size, since its own rounding cannot be undone.

PerLevel<double> floor_at(const Model& m, std::span<const double> q, double condition) {
  const double size = nominal_size(m);
  double driven = 1;
  for (const Driver& d : m.drivers) {
    const Entity& e = m.entities[d.coordinate];
    driven = std::max(driven, std::abs(q[e.first]) / (is_length(e.kind) ? size : 1));
  }
  PerLevel<double> floor = accuracy_limit(std::max(1.0, condition), std::ldexp(1, -53));
  for (const Level level : levels) floor[level] *= driven;
  return floor;
}

/// Conditions and floors of what is right. conditions: those of a closed form, if they are to be
/// used, which know better than the equations how far a long chain passes an error on. motion: what
/// errors are relative to, if not to what is compared.
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

std::vector<int> coordinates_of(const Model& part, const Model& whole) {
  std::vector<int> coordinate(part.coordinates());
  for (const Entity& e : part.entities)
    for (int i = 0; !e.fixed && i < e.size; ++i)
      coordinate[e.first + i] = whole.entities[whole.find(e.name)].first + i;
  return coordinate;
}

double max_link(const DyadChain& chain) {
  double longest = chain.crank;
  for (const DyadChain::Dyad& d : chain.dyads) longest = std::max({longest, d.coupler, d.rocker});
  return longest;
}

/// The mechanism of one of the chains.
Model alone(const KnownCase& p, std::size_t index) {
  const ExtremeCase& c = *p.definition;
  if (c.chains.size() == 1) return p.modelled->model;
  MechanismBuilder d(c.scene.mechanism.name, 2);
  d.set_length_unit(c.scene.mechanism.length_unit);
  add(d, c.chains[index]);
  return model_mechanism(d.take(), {c.scene.motions[index]}).model;
}

/// Where, on the way from a time to another, a chain that has an answer at one of them ceases or
/// begins to have one.
double end_between(ChainSolution& solution, double from, double to) {
  const bool known = solution.solve(from);
  for (;;) {
    const double middle = from + (to - from) / 2;
    if (middle <= from || middle >= to) return middle;
    (solution.solve(middle) == known ? from : to) = middle;
  }
}

}  // namespace

Answers chain_answers(KnownCase& p, std::size_t index) {
  const ExtremeCase& c = *p.definition;
  const DyadChain& chain = c.chains[index];
  Answers a{.model = alone(p, index), .coordinate = {}, .right = {}, .floor = {}, .scales = {}};
  a.coordinate = coordinates_of(a.model, p.modelled->model);
  const double size = nominal_size(a.model), longest = max_link(chain);
  const std::size_t links = std::max<std::size_t>(1, chain.dyads.size());
  a.chain_length = longest * static_cast<double>(links) / size;
  ChainSolution solution(chain, a.model);
  std::vector<double> conditions;
  std::vector<ReferenceInstant> motion;  // what is said of errors is relative to all of it
  std::vector<double> start(a.model.coordinates());
  std::size_t next = 0;
  bool before = true;
  for (std::size_t i = 0; i < p.solvable.size(); ++i) {
    if (c.starts) {
      for (std::size_t j = 0; j < start.size(); ++j) start[j] = p.starts[i][a.coordinate[j]];
      solution.declare(start);
    }
    const double t = c.scene.grid.time(c.starts ? 0 : static_cast<int>(i));
    const bool solved = solution.solve(t);
    if (!c.starts && i > 0 && solved != before) {
      p.ends.push_back(end_between(solution, c.scene.grid.time(static_cast<int>(i) - 1), t));
      solution.solve(t);
    }
    before = solved;
    if (!solved) p.solvable[i] = false;
    if (solved && c.bound == Bound::estimates) motion.push_back(solution.instant());
    if (next == p.compared.size() || p.compared[next] != static_cast<int>(i)) continue;
    ++next;
    a.right.push_back(solved ? solution.instant() : ReferenceInstant{t, {}, {}, {}});
    if (c.bound == Bound::length) conditions.push_back(solution.condition());
  }
  add_floors(a, conditions, std::move(motion));
  // An angle's error is what it moves the end of its link by, or long chains would leave it less
  // than the rounding of that point.
  if (c.bound == Bound::length) a.scales.rotation.position = size / longest;
  return a;
}

Answers reference_answers(const KnownCase& p) {
  const ExtremeCase& c = *p.definition;
  Answers a{.model = p.modelled->model, .coordinate = {}, .right = {}, .floor = {}, .scales = {}};
  a.coordinate.resize(a.model.coordinates());
  std::iota(a.coordinate.begin(), a.coordinate.end(), 0);
  std::vector<double> times;
  for (const int i : p.compared)
    if (p.solvable[i]) times.push_back(c.scene.grid.time(c.starts ? 0 : i));
  if (c.starts) times.resize(1);
  const Reference reference = make_reference(a.model, times);
  if (!(reference.floor.position < 1e-20))
    throw std::runtime_error("the two references differ by more than 1e-20");
  a.right = reference.instants;
  if (c.starts) a.right.resize(p.compared.size(), reference.instants.front());
  a.right.resize(p.compared.size(), {c.scene.grid.time(p.compared.back()), {}, {}, {}});
  add_floors(a, {});
  return a;
}

}  // namespace desmo::extremes
