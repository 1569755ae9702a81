#include "bench/stability/judgement.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "bench/stability/allowed.h"

namespace desmo::extreme {

namespace {

constexpr PerLevel<const char*> level_names{"position", "velocity", "acceleration"};

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
        std::string& first =
            is_wrong(e, p.definition->scene.tolerance, stated) ? found.defect : found.inexact;
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

bool is_named(const Mechanism& m, GroupId group, const std::string& body) {
  return group >= 0 && std::ranges::count(m.groups[group].bodies, body) > 0;
}

/// What was expected and is not there, although nothing is wrong.
std::string shortcoming(const Problem& p, const Attempt& a, const Yardsticks& yardsticks) {
  const ExtremeCase& c = *p.definition;
  if (std::string why = needless_flag(p, a); !why.empty()) return why;
  if (c.bound == Bound::first_case && yardsticks.first_case)
    if (std::string why = other_iterations(a, *yardsticks.first_case); !why.empty()) return why;
  if (!c.failing_body.empty() && !is_named(p.model->mechanism, a.failed_group, c.failing_body))
    return "it does not name the group of " + c.failing_body;
  if (c.is_redundant && p.model->left_out.empty()) return "it does not report the redundancy";
  if (!c.to_be_said.empty()) return "it does not say " + c.to_be_said;
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
  if (!errors.inexact.empty()) return end(Verdict::missed, std::move(errors.inexact));
  if (std::string why = shortcoming(p, a, yardsticks); !why.empty())
    return end(Verdict::missed, std::move(why));
  return j;
}

}  // namespace desmo::extreme
