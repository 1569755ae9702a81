#include "bench/stability/problem.h"

#include <algorithm>
#include <exception>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "bench/stability/chain_solution.h"
#include "bench/stability/floor.h"
#include "bench/stability/starts.h"
#include "formulations/reference.h"

namespace desmo::extreme {

namespace {

constexpr int spread_instants = 201;
constexpr int inverted_coordinates = 1000;  // of larger ones no inverse is computed

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

/// Conditions and floors of what is right.
void judge_by(Answers& a, const std::vector<double>& conditions) {
  ConditionNumber number(a.mechanism);
  const bool is_inverted = a.mechanism.coordinates() <= inverted_coordinates;
  for (std::size_t i = 0; i < a.right.size(); ++i) {
    PerLevel<double>& floor = a.floor.emplace_back();
    const ReferenceInstant& right = a.right[i];
    if (right.q.empty()) continue;
    const double condition = is_inverted ? number(right.q) : conditions[i];
    floor = floor_at(a.mechanism, right.q, condition);
    a.condition = std::max(a.condition, condition);
  }
  std::vector<ReferenceInstant> known;
  std::ranges::copy_if(a.right, std::back_inserter(known),
                       [](const ReferenceInstant& r) { return !r.q.empty(); });
  a.scales = make_scales(a.mechanism, known);
}

std::vector<int> coordinates_of(const Mechanism& part, const Mechanism& whole) {
  std::vector<int> coordinate(part.coordinates());
  for (const Entity& e : part.entities)
    for (int i = 0; !e.fixed && i < e.size; ++i)
      coordinate[e.first + i] = whole.entities[whole.find(e.name)].first + i;
  return coordinate;
}

double length_of(const DyadChain& chain, double size) {
  double longest = chain.crank;
  for (const DyadChain::Dyad& d : chain.dyads) longest = std::max({longest, d.coupler, d.rocker});
  return longest * static_cast<double>(std::max<std::size_t>(1, chain.dyads.size())) / size;
}

/// By the closed form. Where a chain cannot be solved, the whole cannot.
Answers chain_answers(Problem& p, std::size_t index) {
  const ExtremeCase& c = *p.definition;
  const DyadChain& chain = c.chains[index];
  Describer d(c.scene.mechanism.name, 2);
  d.set_length_unit(c.scene.mechanism.length_unit);
  add(d, chain);
  Answers a{.mechanism = model(d.take(), {c.scene.motions[index]}).mechanism,
            .coordinate = {},
            .right = {},
            .floor = {},
            .scales = {}};
  a.coordinate = coordinates_of(a.mechanism, p.model->mechanism);
  a.chain_length = length_of(chain, nominal_size(a.mechanism));
  ChainSolution solution(chain, a.mechanism);
  std::vector<double> conditions;
  std::vector<double> start(a.mechanism.coordinates());
  std::size_t next = 0;
  for (std::size_t i = 0; i < p.solvable.size(); ++i) {
    if (c.starts) {
      for (std::size_t j = 0; j < start.size(); ++j) start[j] = p.starts[i][a.coordinate[j]];
      solution.declare(start);
    }
    const double t = c.scene.grid.time(c.starts ? 0 : static_cast<int>(i));
    const bool solved = solution.solve(t);
    if (!solved) p.solvable[i] = false;
    if (next == p.compared.size() || p.compared[next] != static_cast<int>(i)) continue;
    ++next;
    a.right.push_back(solved ? solution.instant() : ReferenceInstant{t, {}, {}, {}});
    conditions.push_back(solution.condition());
  }
  judge_by(a, conditions);
  return a;
}

/// By two formulations in quadruple precision.
Answers reference_answers(const Problem& p) {
  const ExtremeCase& c = *p.definition;
  Answers a{
      .mechanism = p.model->mechanism, .coordinate = {}, .right = {}, .floor = {}, .scales = {}};
  a.coordinate.resize(a.mechanism.coordinates());
  std::iota(a.coordinate.begin(), a.coordinate.end(), 0);
  std::vector<double> times;
  for (const int i : p.compared)
    if (p.solvable[i]) times.push_back(c.scene.grid.time(c.starts ? 0 : i));
  if (c.starts) times.resize(1);
  const Reference reference = make_reference(a.mechanism, times);
  if (!(reference.floor.position < 1e-20))
    throw std::runtime_error("the two references differ by more than 1e-20");
  a.right = reference.instants;
  if (c.starts) a.right.resize(p.compared.size(), reference.instants.front());
  a.right.resize(p.compared.size(), {c.scene.grid.time(p.compared.back()), {}, {}, {}});
  judge_by(a, {});
  return a;
}

}  // namespace

Problem make_problem(const ExtremeCase& c) {
  Problem p{.definition = &c,
            .model = {},
            .refusal = {},
            .no_answer = {},
            .answers = {},
            .compared = compared_instants(c),
            .solvable = {},
            .starts = {}};
  p.solvable.assign(c.starts ? c.starts->count : c.scene.grid.instants, true);
  if (c.ends_singular) p.solvable.back() = false;
  try {
    p.model = model(c.scene.mechanism, c.scene.motions);
  } catch (const std::invalid_argument& error) {
    p.refusal = error.what();
    return p;
  }
  if (c.starts) p.starts = make_starts(p.model->mechanism, *c.starts);
  if (c.is_refused) return p;  // there is none
  try {
    for (std::size_t i = 0; i < c.chains.size(); ++i) p.answers.push_back(chain_answers(p, i));
    if (c.chains.empty() && p.model->mechanism.coordinates() > 0)
      p.answers.push_back(reference_answers(p));
  } catch (const std::exception& error) {
    p.no_answer = error.what();
    p.answers.clear();
  }
  return p;
}

}  // namespace desmo::extreme
