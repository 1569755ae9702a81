#include "formulations/stepping/formulation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <utility>

#include "formulations/stepping/diagnosis.h"
#include "formulations/stepping/straight_way.h"

namespace desmo {

namespace {

void set(State& state, int coordinate, const MotionSample<double>& z) {
  state.q[coordinate] = z.position;
  state.qd[coordinate] = z.velocity;
  state.qdd[coordinate] = z.acceleration;
}

}  // namespace

void drive(const Model& m, double t, State& state) {
  for (const Driver& d : m.drivers) set(state, m.entities[d.coordinate].first, sample(d.motion, t));
}

std::string describe(const Summary& s, const Model& m) {
  char text[160];
  if (s.ok()) {
    std::snprintf(text, sizeof text, "converged: %ld instants, %ld iterations, residual %.2e",
                  s.instants, s.iterations, s.residual);
    return text;
  }
  const char* reason = s.status == Status::singular        ? "singular Jacobian"
                       : s.status == Status::not_converged ? "no convergence"
                                                           : "the equations are not finite";
  std::snprintf(text, sizeof text, "%s at t = %.9g s, residual %.2e", reason, s.time, s.residual);
  std::string result = text;
  if (s.group >= 0) result += ", group '" + m.groups[s.group].name + "'";
  if (s.constraint >= 0) result += ", constraint '" + m.constraints[s.constraint].name + "'";
  return result;
}

namespace {

double sum_of_tolerances(const std::vector<Formulation::DefinedPart>& parts) {
  double norm = 0;
  for (const Formulation::DefinedPart& part : parts) norm = std::hypot(norm, part.tolerance);
  return norm;
}

/// Goes from a time to another in pieces. One that cannot be gone is halved, down to the shortest;
/// the next is twice as long again. go(to) goes there, and says whether it could.
template <class Go>
bool go_in_pieces(double from, double to, Go&& go) {
  constexpr double shortest = 0x1p-10;  // of all
  double reached = from, piece = (to - from) / 2;
  while (true) {
    const bool is_last = !(std::abs(to - reached) > std::abs(piece));
    const double next = is_last ? to : reached + piece;
    if (go(next)) {
      if (is_last) return true;
      reached = next;
      piece *= 2;
    } else {
      piece = (next - reached) / 2;
      if (!(std::abs(piece) >= shortest * std::abs(to - from))) return false;
    }
  }
}

}  // namespace

Formulation::Formulation(const Model& model, std::vector<DefinedPart> parts,
                         const Settings& settings, std::unique_ptr<WholeMotion> whole_motion)
    : model_(model),
      motions_({}),
      parts_(std::move(parts)),
      settings_(settings),
      tolerance_(std::max(settings.tolerance, sum_of_tolerances(parts_))),
      whole_motion_(std::move(whole_motion)) {
  for (State* s : {&state_, &before_})
    for (std::vector<double>* values : {&s->q, &s->qd, &s->qdd})
      values->resize(model_.state_size());
  prepare();
}

long Formulation::refactorisations() const {
  long sum = 0;
  for (const DefinedPart& part : parts_) sum += part.solver->refactorisations();
  return sum;
}

void Formulation::prepare() {
  constant_.clear();
  moving_.clear();
  keepers_.clear();
  near_.clear();
  std::array<std::vector<int>, 3> unknowns;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const DefinedPart& part = parts_[i];
    (part.definition.constant ? constant_ : moving_)
        .push_back({part.solver.get(), part.level, static_cast<int>(i),
                    static_cast<int>(part.definition.unknowns.size())});
    if (part.definition.constant) continue;
    std::ranges::copy(part.solver->starts_from(part.definition.unknowns),
                      std::back_inserter(unknowns[static_cast<std::size_t>(part.level)]));
    std::ranges::copy(part.solver->stays_near(), std::back_inserter(near_));
    if (Keeper* const keeper = part.solver->keeper()) keepers_.add(*keeper, part.level);
  }
  for (std::size_t level = 0; level < unknowns.size(); ++level) {
    std::ranges::sort(unknowns[level]);
    // Rates of earlier instants are of use where there are accelerations.
    const Guess guess = static_cast<Level>(level) == Level::acceleration
                            ? settings_.guess
                            : std::min(settings_.guess, Guess::hermite5);
    predictors_[level] = Predictor(guess, runs_of(unknowns[level]));
  }
  make_runs();
  sample_drivers();
}

/// All drivers are given to the state, until want() says who reads them there.
void Formulation::sample_drivers() {
  const PlacedMotions all = driver_motions(model_);
  std::vector<const Motion*> of_coordinate(model_.state_size()), sampled;
  for (std::size_t i = 0; i < all.places.size(); ++i) of_coordinate[all.places[i]] = all.motions[i];
  std::vector<int> in_row(model_.state_size(), -1);
  const auto add = [&](int coordinate) {
    in_row[coordinate] = static_cast<int>(sampled.size());
    sampled.push_back(of_coordinate[coordinate]);
  };
  std::ranges::for_each(keepers_.drivers(), add);
  drivers_.clear();
  for (const int coordinate : all.places) {
    if (in_row[coordinate] < 0) add(coordinate);
    drivers_.push_back({coordinate, in_row[coordinate]});
  }
  driven_in_state_ = drivers_;
  motions_ = MotionsAhead(std::move(sampled));
  sampled_ = {};
}

/// Of moving parts behind each other that are solved to the same level.
void Formulation::make_runs() {
  runs_.clear();
  std::vector<Part*> solvers;
  for (const Stage& stage : moving_) solvers.push_back(stage.solver);
  std::size_t same_level = 0;  // the end of the parts that are solved to one level
  for (std::size_t first = 0; first < moving_.size();) {
    while (same_level < moving_.size() &&
           (same_level <= first || moving_[same_level].level == moving_[first].level))
      ++same_level;
    std::unique_ptr<PartRun> run =
        solvers[first]->make_run(std::span(solvers).subspan(first, same_level - first));
    const int members = run ? run->size() : 1;
    for (int i = 0; run && i < members; ++i) {
      moving_[first + i].run = run.get();
      moving_[first + i].member = i;
    }
    if (run) runs_.push_back(std::move(run));
    first += members;
  }
}

void Formulation::forget() {
  for (const DefinedPart& part : parts_) part.solver->forget();
  for (const auto& run : runs_) run->forget();
}

void Formulation::end_assembly() {
  for (const DefinedPart& part : parts_) part.solver->end_assembly();
}

void Formulation::want(std::span<const int> coordinates, bool in_rooms) {
  if (in_rooms == wanted_.in_rooms && std::ranges::equal(coordinates, wanted_.coordinates)) return;
  if (in_rooms) keepers_.prepare_rooms(coordinates, model_);
  wanted_.coordinates.assign(coordinates.begin(), coordinates.end());
  wanted_.in_rooms = in_rooms;
  std::vector<bool> read(model_.state_size(), !in_rooms && coordinates.empty());
  const auto are_read = [&](std::span<const int> all) {
    for (const int i : all) read[i] = true;
  };
  are_read(in_rooms ? keepers_.not_kept() : wanted_.coordinates);
  for (const DefinedPart& part : parts_) {
    const auto& [groups, unknowns, equations, constant] = part.definition;
    are_read(part.solver->starts_from(unknowns));
    are_read(part.solver->stays_near());
    if (const Keeper* const keeper = part.solver->keeper()) {
      are_read(keeper->reads());
      continue;
    }
    for (const int i : states_read(model_, part.definition))
      if (!std::ranges::binary_search(unknowns, i)) read[i] = true;
  }
  for (const DefinedPart& part : parts_) part.solver->write_only(read);
  std::vector<bool> kept(read.size());
  for (const int i : keepers_.drivers()) kept[i] = true;
  driven_in_state_.clear();
  std::ranges::copy_if(drivers_, std::back_inserter(driven_in_state_), [&](const Driven& driver) {
    return read[driver.coordinate] || !kept[driver.coordinate];
  });
}

/// In the observer's rooms where that saves anything.
void Formulation::want_as(const Request& request, Observer& observer) {
  const auto rooms = keepers_.empty() ? std::nullopt : observer.rooms();
  rooms ? want(rooms->coordinates, true) : want(request.coordinates);
}

void Formulation::solve_only(std::span<const Level> needed) {
  if (settings_.stride > 1) return;
  if (whole_motion_) whole_motion_->solve_only(needed);
  for (DefinedPart& part : parts_) {
    part.level = Level::position;
    for (const int i : part.definition.unknowns) part.level = std::max(part.level, needed[i]);
  }
  prepare();
}

/// Leaves the last instant in before_ and in state_ the drivers that are read there and what
/// solvers start from; the rest of state_ is of the instant before, and of no meaning until it is
/// solved. Sines of drivers take longest and wait for nothing: they come first.
void Formulation::begin_step(double t) {
  const StepHistory history{t - now_.time, now_.time - then_.time, now_.level, then_.level};
  std::swap(state_, before_);
  drive(t);
  const State &last = before_, &one_before = state_;
  for (std::size_t level = 0; level < predictors_.size(); ++level)
    if (Predictor& predictor = predictors_[level]; !predictor.empty())
      predictor(history.up_to(static_cast<Level>(level)), last, one_before, state_.q.data());
  for (const int i : near_) state_.q[i] = before_.q[i];
  keepers_.begin_step(history, sampled_);
}

/// As the function of that name, all drivers at once, as far as they are read in the state.
void Formulation::drive(double t) {
  sampled_ = motions_(t);
  write(driven_in_state_);
}

/// As they were sampled last, to the state.
void Formulation::write(std::span<const Driven> drivers) {
  for (const auto& [coordinate, in_row] : drivers)
    set(state_, coordinate, {sampled_.z[in_row], sampled_.zd[in_row], sampled_.zdd[in_row]});
}

Summary Formulation::solve(std::span<const Stage> stages, double t, Level level) {
  Summary summary;
  summary.time = t;
  double residual2 = 0;
  for (std::size_t i = 0; i < stages.size();) {
    if (PartRun* const run = stages[i].run) {
      const Stage& first = stages[i];
      const PartRun::Result r = run->solve(state_, first.member, std::min(level, first.level));
      residual2 += r.residual2;
      summary.iterations = std::max<long>(summary.iterations, r.iterations);
      summary.updates += r.all * first.unknowns;
      i += r.solved;
      if (first.member + r.solved == run->size()) continue;
    }
    const Stage& stage = stages[i++];
    const PartResult r = stage.solver->solve(state_, before_.q, std::min(level, stage.level));
    residual2 += r.residual2;
    summary.iterations = std::max<long>(summary.iterations, r.iterations);
    summary.updates += static_cast<long>(r.iterations) * stage.unknowns;
    if (r.status != Status::converged) {
      const PartDefinition& definition = parts_[stage.part].definition;
      summary.status = r.status;
      keepers_.write_last(before_.q);
      if (sampled_.z) write(drivers_);  // which the search needs
      for (const int i : definition.unknowns) state_.q[i] = before_.q[i];
      const Culprit c = find_culprit(model_, definition.groups, state_.q, settings_);
      summary.group = c.group;
      summary.constraint = c.constraint;
      break;
    }
  }
  summary.residual = std::sqrt(residual2);
  summary.instants = summary.ok();
  return summary;
}

Summary Formulation::assemble(double t, Level level) {
  want({});
  return assemble_alone(t, level);
}

Summary Formulation::assemble_alone(double t, Level level) {
  std::ranges::copy(model_.estimate, state_.q.begin());
  std::ranges::copy(model_.fixed_values, state_.q.begin() + model_.coordinates());
  for (State* s : {&state_, &before_}) {
    std::ranges::fill(s->qd, 0.0);
    std::ranges::fill(s->qdd, 0.0);
  }
  std::ranges::copy(state_.q, before_.q.begin());
  forget();
  assembled_ = false;
  now_ = then_ = {};  // nothing to extrapolate from
  Summary summary = solve(constant_, t, level);
  if (!summary.ok()) return summary;
  before_ = state_;  // what is solved once is in both
  assembled_ = true;
  summary = advance(t, level);
  // The estimate may be far off: a fixed number of iterations is for steps.
  for (int i = 0; i < settings_.max_iterations && summary.ok() && settings_.fixed_iterations > 0 &&
                  summary.residual >= tolerance_;
       ++i) {
    const Summary before = summary;
    now_ = then_ = {};
    summary = advance(t, level);
    summary.iterations += before.iterations;
    summary.updates += before.updates;
  }
  assembled_ = summary.ok();
  end_assembly();
  return summary;
}

Summary Formulation::step(double t, Level level) {
  want({});
  return advance(t, level);
}

Summary Formulation::advance(double t, Level level) {
  const auto go = [&](double to, Level as_far_as) {
    begin_step(to);
    const Summary summary = solve(moving_, to, as_far_as);
    if (!summary.ok()) std::ranges::copy(before_.q, state_.q.begin());
    then_ = summary.ok() ? now_ : Solved{};
    now_.time = to;
    now_.level = summary.ok() ? std::optional(as_far_as) : std::nullopt;
    return summary;
  };
  const Solved start = now_;
  const bool was_assembled = assembled_;
  Summary summary = was_assembled ? go(t, level) : assemble_alone(t, level);
  if (summary.ok() || !was_assembled || !start.level || start.time == t) [[likely]]
    return summary;

  const std::vector<double> position = state_.q;
  const Summary at_once = summary;
  long iterations = at_once.iterations, updates = at_once.updates;
  const bool arrived = go_in_pieces(start.time, t, [&](double to) {
    summary = go(to, to == t ? level : Level::position);
    iterations += summary.iterations;
    updates += summary.updates;
    return summary.ok();
  });
  if (arrived) {
    summary.iterations = iterations;
    summary.updates = updates;
  } else {
    std::ranges::copy(position, state_.q.begin());
    summary = at_once;
  }
  return summary;
}

bool Formulation::enter(std::span<const double> q, double t) {
  want({});
  for (State* s : {&state_, &before_}) {
    std::ranges::copy(q, s->q.begin());
    std::ranges::fill(s->qd, 0.0);
    std::ranges::fill(s->qdd, 0.0);
  }
  forget();
  now_ = then_ = {};
  const auto solve = [&](State& state, std::span<const double> last) {
    return solve_positions(state, last);
  };
  assembled_ = go_straight(model_, t, state_, solve);
  if (!assembled_) return false;
  before_.q = state_.q;
  drive(t);  // whole turns
  assembled_ = solve_positions(state_, before_.q);
  end_assembly();
  return assembled_;
}

bool Formulation::solve_positions(State& state, std::span<const double> last) {
  return std::ranges::all_of(moving_, [&](const Stage& stage) {
    return stage.solver->solve(state, last, Level::position).status == Status::converged;
  });
}

}  // namespace desmo
