#include "bench/stability/attempt.h"

#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "bench/stability/applicability.h"
#include "formulations/accuracy/error.h"

namespace desmo::extreme {

namespace {

/// Compares what a formulation found with what is right.
class Comparison {
 public:
  explicit Comparison(const Problem& problem) : problem_(problem) {}

  /// next: which of the compared instants it is.
  void operator()(const Formulation& f, std::size_t next, Attempt& attempt) const {
    for (std::size_t k = 0; k < problem_.answers.size(); ++k) {
      const Answers& answers = problem_.answers[k];
      const ReferenceInstant& right = answers.right[next];
      if (!right.q.empty()) attempt.errors[k][next] = error(f, answers, right);
    }
  }

 private:
  PerLevel<double> error(const Formulation& f, const Answers& answers,
                         const ReferenceInstant& right) const {
    const auto part = [&](std::span<const double> whole) {
      std::vector<double> values;
      for (const int i : answers.coordinate) values.push_back(whole[i]);
      return values;
    };
    std::vector<double> q = part(f.q());
    if (problem_.definition->starts) turn_back(answers.mechanism, right.q, q);
    const std::vector<double> qd = part(f.qd()), qdd = part(f.qdd());
    ErrorMeasure measure(answers.mechanism, {&right, 1}, answers.scales);
    measure.accept({0, right.time, q, qd, qdd});
    const Error e = measure.error();
    return {e.position.max, e.velocity.max, e.acceleration.max};
  }

  /// Whole turns mean nothing where an estimate alone says where an angle is.
  static void turn_back(const Mechanism& m, std::span<const double> right, std::vector<double>& q) {
    constexpr double turn = 2 * std::numbers::pi;
    for (const Entity& e : m.entities)
      if (e.kind == EntityKind::angle && !e.fixed)
        q[e.first] -= turn * std::nearbyint((q[e.first] - right[e.first]) / turn);
  }

  const Problem& problem_;
};

void note_failure(Attempt& attempt, const Summary& summary, const Mechanism& m) {
  if (!attempt.message.empty()) return;
  attempt.message = describe(summary, m);
  attempt.failed_group = summary.group;
}

}  // namespace

Attempt attempt(const Problem& problem, const Configuration& configuration) {
  Attempt a;
  const auto stop = [&](Attempt::Ending ending, std::string why) {
    a.ending = ending;
    a.message = std::move(why);
    return a;
  };
  if (!problem.model) return stop(Attempt::Ending::refused, problem.refusal);
  if (std::string why = why_not_tried(configuration, problem); !why.empty())
    return stop(Attempt::Ending::not_applicable, std::move(why));

  Mechanism m = problem.model->mechanism;  // its estimate changes from start to start
  std::unique_ptr<Formulation> f;
  try {
    f = make_formulation(*configuration.variant, m, configuration.settings);
  } catch (const std::invalid_argument& error) {
    return stop(Attempt::Ending::refused, error.what());
  }
  if (std::string why = lacks_generated_code(*f); !why.empty())
    return stop(Attempt::Ending::not_applicable, std::move(why));

  for (const Answers& answers : problem.answers) a.errors.emplace_back(answers.right.size());
  const Comparison compare(problem);
  const ExtremeCase& c = *problem.definition;
  std::size_t next = 0;
  for (std::size_t i = 0; i < problem.solvable.size(); ++i) {
    if (c.starts) m.estimate = problem.starts[i];
    const double t = c.scene.grid.time(c.starts ? 0 : static_cast<int>(i));
    const Summary summary = i == 0 || c.starts ? f->assemble(t) : f->step(t);
    a.steps.push_back({!summary.ok(), static_cast<int>(summary.iterations)});
    const bool is_compared =
        next < problem.compared.size() && problem.compared[next] == static_cast<int>(i);
    if (is_compared && summary.ok()) compare(*f, next, a);
    next += is_compared;
    if (summary.ok()) continue;
    note_failure(a, summary, m);
    if (!c.goes_on && !c.starts) break;
  }
  return a;
}

}  // namespace desmo::extreme
