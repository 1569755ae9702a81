#include "bench/experiments/extremes/verification.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "bench/experiments/extremes/allowed.h"

namespace desmo::extremes {

namespace {

constexpr PerLevel<const char*> level_names{"position", "velocity", "acceleration"};

/// Bytes that a long run may hold more of at its end: factors made anew are not always of one size.
constexpr std::int64_t max_growth = 4096;

std::string formatted(const char* format, auto... values) {
  char text[256];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

/// An instant, for people: its time, or which start it is.
std::string at(const Problem& p, std::size_t instant) {
  if (p.definition->starts) return formatted("from start %zu", instant + 1);
  return formatted("at t = %.9g s", p.definition->scene.grid.time(static_cast<int>(instant)));
}

using Flag = Attempt::Flag;

/// The worst of an attempt's errors, and the first that is wrong, or only more than is allowed.
struct Errors {
  std::optional<PerLevel<WorstError>> worst;
  std::string defect, inexact;
};

/// What is neither within the tolerance that was asked for nor for conditioning to excuse is wrong,
/// unless a bound that stands with it says so.
bool is_wrong(const WorstError& e, double tolerance, double stated) {
  return e.error > std::max({e.allowed, 10 * std::max(tolerance, e.floor), stated});
}

Errors errors_of(const Problem& p, const Attempt& a, const Allowed& allowed) {
  Errors found;
  for (std::size_t part = 0; part < a.errors.size(); ++part)
    for (std::size_t next = 0; next < a.errors[part].size(); ++next) {
      const Flag flag = a.steps.size() > static_cast<std::size_t>(p.compared[next])
                            ? a.steps[p.compared[next]].flag
                            : Flag::failed;
      if (!a.errors[part][next] || flag == Flag::doubtful) continue;
      if (!found.worst) found.worst.emplace();
      for (const Level level : levels) {
        const WorstError e{(*a.errors[part][next])[level], p.answers[part].floor[next][level],
                           allowed(level, part, next)};
        WorstError& worst = (*found.worst)[level];
        if (worst.allowed == 0 || e.error * worst.allowed > worst.error * e.allowed) worst = e;
        if (!(e.error > e.allowed)) continue;
        const double stated = flag == Flag::degraded ? a.stated[next]->bound[level] : 0;
        const bool wrong = p.definition->bound == Bound::estimates ||
                           is_wrong(e, p.definition->scene.tolerance, stated);
        std::string& first = wrong ? found.defect : found.inexact;
        if (first.empty())
          first = formatted("%s wrong by %.1e %s, allowed %.1e", level_names[level], e.error,
                            at(p, p.compared[next]).c_str(), e.allowed);
      }
    }
  return found;
}

/// The first instant with numbers where there is no answer.
std::string unflagged(const Problem& p, const Attempt& a) {
  if (p.definition->is_refused) return {};
  for (std::size_t i = 0; i < a.steps.size(); ++i)
    if (a.steps[i].flag == Flag::none && !p.solvable[i])
      return "plain numbers " + at(p, i) + ", where there is no answer";
  return {};
}

/// Whether conditioning explains that an instant, one of those compared, is degraded.
bool is_excused(const Problem& p, const Attempt& a, std::size_t instant) {
  constexpr double most_over_floor = 1000;
  const auto found = std::ranges::lower_bound(p.compared, static_cast<int>(instant));
  if (found == p.compared.end() || *found != static_cast<int>(instant)) return true;
  const std::size_t next = found - p.compared.begin();
  return std::ranges::any_of(p.answers, [&](const Answers& of_part) {
    return std::ranges::all_of(levels, [&](Level l) {
      return a.stated[next]->bound[l] <= most_over_floor * of_part.floor[next][l];
    });
  });
}

std::string needless_flag(const Problem& p, const Attempt& a) {
  if (p.definition->may_fail) return {};
  for (std::size_t i = 0; i < a.steps.size(); ++i)
    if (p.solvable[i] && a.steps[i].flag != Flag::none &&
        !(a.steps[i].flag == Flag::degraded && is_excused(p, a, i)))
      return a.message.empty() ? "failed " + at(p, i) : a.message;
  return {};
}

std::string other_iterations(const Attempt& a, const Attempt& first) {
  for (std::size_t i = 0; i < std::min(a.steps.size(), first.steps.size()); ++i)
    if (std::abs(a.steps[i].iterations - first.steps[i].iterations) > 1)
      return formatted("%g iterations where the first case has %g", a.steps[i].iterations,
                       first.steps[i].iterations);
  return {};
}

bool is_named(const Model& m, GroupId group, const std::string& body) {
  return group >= 0 && std::ranges::count(m.groups[group].bodies, body) > 0;
}

/// By which factor an estimate of the condition number may be off.
constexpr double most_off = 10;

double condition_of(const Problem& p) {
  double condition = 0;
  for (const Answers& of_part : p.answers) condition = std::max(condition, of_part.condition);
  return condition;
}

/// A condition number that is said to be much smaller than it is.
std::string understated_condition(const Problem& p, const Attempt& a) {
  const double condition = condition_of(p);
  if (p.definition->bound != Bound::estimates || a.most.condition >= condition / most_off)
    return {};
  return formatted("condition %.1e said to be %.1e", condition, a.most.condition);
}

/// What is said of the whole run, where it says too much.
std::string overstated(const Problem& p, const Attempt& a) {
  const double condition = condition_of(p);
  if (!(a.most.condition <= most_off * condition))
    return formatted("condition %.1e said to be %.1e", condition, a.most.condition);
  double allowed =
      p.definition->factor * std::max(p.definition->scene.tolerance, std::ldexp(condition, -53));
  for (const Level level : levels) {
    if (!(a.most.bound[level] <= allowed))
      return formatted("%s said to be wrong by up to %.1e, more than %.1e", level_names[level],
                       a.most.bound[level], allowed);
    allowed *= std::max(condition, 1.0);
  }
  return {};
}

/// An end of what cannot be solved that a run went on past, where it is not known well enough.
std::string wrong_end(const Problem& p, const Attempt& a) {
  constexpr double bracket = 1e-9;  // s
  std::vector<double> found;
  for (const Gap& gap : a.gaps) {
    found.push_back(gap.from);
    if (gap.ends) found.push_back(gap.to);
  }
  for (std::size_t i = 0; i < std::min(found.size(), p.ends.size()); ++i)
    if (!(std::abs(found[i] - p.ends[i]) <= bracket))
      return formatted("it says %.12g s where the answer ends or begins at %.12g s", found[i],
                       p.ends[i]);
  return found.size() == p.ends.size()
             ? ""
             : formatted("it says %zu ends of answers of %zu", found.size(), p.ends.size());
}

bool is_idle(const ModellingResult& modelled, const std::string& body) {
  return std::ranges::count(modelled.idle, body, &IdleFreedom::body) > 0;
}

/// What was expected and is not there, although nothing is wrong.
std::string shortcoming(const Problem& p, const Attempt& a, const Yardsticks& yardsticks) {
  const ExtremeCase& c = *p.definition;
  if (c.bound == Bound::first_case && yardsticks.first_case)
    if (std::string why = other_iterations(a, *yardsticks.first_case); !why.empty()) return why;
  if (c.bound == Bound::estimates)
    if (std::string why = overstated(p, a); !why.empty()) return why;
  if (!c.failing_body.empty() && !is_named(p.modelled->model, a.failed_group, c.failing_body))
    return "it does not name the group of " + c.failing_body;
  if (c.is_redundant && p.modelled->left_out.empty()) return "it does not report the redundancy";
  if (c.goes_on)
    if (std::string why = wrong_end(p, a); !why.empty()) return why;
  if (!c.idle_body.empty() && !is_idle(*p.modelled, c.idle_body))
    return "it does not report that " + c.idle_body + " may spin";
  if (a.heap_growth > max_growth)
    return formatted("the heap has grown by %lld bytes", static_cast<long long>(a.heap_growth));
  return {};
}

Judgement without_numbers(Outcome outcome, Verdict verdict, std::string reason) {
  return {.outcome = outcome, .verdict = verdict, .reason = std::move(reason), .worst = {}};
}

}  // namespace

Judgement judge(const Problem& p, const Attempt& a, const Yardsticks& yardsticks) {
  const ExtremeCase& c = *p.definition;
  if (a.ending == Attempt::Ending::not_applicable)
    return without_numbers(Outcome::not_applicable, Verdict::not_applicable, a.message);
  if (a.ending == Attempt::Ending::refused)
    return without_numbers(Outcome::refused, c.is_refused ? Verdict::as_expected : Verdict::missed,
                           c.is_refused ? "" : a.message);
  if (!p.no_answer.empty())
    return without_numbers(Outcome::not_applicable, Verdict::not_applicable,
                           "nothing to compare with: " + p.no_answer);

  Judgement j;
  j.instants = static_cast<long>(a.steps.size());
  j.iterations = a.iterations;
  j.refactorisations = a.refactorisations;
  for (const Attempt::Step& step : a.steps) {
    if (step.flag == Flag::failed) j.outcome = Outcome::failed;
    if (step.flag != Flag::none && j.outcome == Outcome::converged) j.outcome = Outcome::degraded;
  }
  const auto end = [&](Verdict verdict, std::string reason) {
    j.verdict = verdict;
    j.reason = std::move(reason);
    return j;
  };
  if (c.is_refused)
    return j.outcome == Outcome::failed && j.instants == 1
               ? j
               : end(Verdict::defect, "numbers for what is no mechanism");
  Errors errors = errors_of(p, a, Allowed(p, a, yardsticks));
  j.worst = errors.worst;
  if (!errors.defect.empty()) return end(Verdict::defect, std::move(errors.defect));
  if (std::string why = unflagged(p, a); !why.empty()) return end(Verdict::defect, std::move(why));
  if (std::string why = needless_flag(p, a); !why.empty())
    return end(Verdict::missed, std::move(why));
  if (std::string why = understated_condition(p, a); !why.empty())
    return end(Verdict::defect, std::move(why));
  if (!errors.inexact.empty()) return end(Verdict::missed, std::move(errors.inexact));
  if (std::string why = shortcoming(p, a, yardsticks); !why.empty())
    return end(Verdict::missed, std::move(why));
  return j;
}

}  // namespace desmo::extremes
