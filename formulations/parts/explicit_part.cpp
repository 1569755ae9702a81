#include "formulations/parts/explicit_part.h"

#include <algorithm>
#include <utility>

namespace desmo {

namespace {

/// Limit of a core's ‖Φ‖₂ relative to that of the part (<). Unknowns that follow from the core
/// amplify its error.
constexpr double core_share = 1.0 / 8;

/// Numbers of equal steps of a continuation of the torn unknowns: 1 is tried first, then 4.
constexpr int torn_steps[] = {1, 4};

/// A chain of parts that share a kernel, solved in one call of it. A part that the kernel refuses
/// is tried by it once more when it is solved by itself.
class ExplicitChain final : public PartChain {
 public:
  /// parts: of one kernel; they outlive the chain, and what their bindings point to stays where
  /// it is.
  explicit ExplicitChain(std::vector<const ExplicitPart*> parts) : parts_(std::move(parts)) {
    for (const ExplicitPart* const part : parts_) bindings_.push_back(part->binding());
  }

  int size() const override { return static_cast<int>(parts_.size()); }

  Result solve(State& s, int first, Level level) override {
    while (assembled_ < size() && parts_[assembled_]->assembled()) ++assembled_;
    if (assembled_ < size()) return {};
    ExplicitKernel::Solve* const solve =
        parts_.front()->kernel().solve[static_cast<std::size_t>(level)];
    const auto [accepted, iterations, total_iterations, residual2] =
        solve(s.q.data(), s.qd.data(), s.qdd.data(), bindings_.data() + first, size() - first);
    return {accepted, iterations, total_iterations, residual2};
  }

  void forget() override { assembled_ = 0; }

 private:
  std::vector<const ExplicitPart*> parts_;
  // copies of the parts' bindings, next to each other in memory
  std::vector<ExplicitBinding<double>> bindings_;
  int assembled_ = 0;  // number of leading parts found assembled since forget()
};

}  // namespace

ExplicitPart::ExplicitPart(const ExplicitKernel& kernel, const BoundKernel& bound,
                           std::span<const double> weights, const PartSettings& settings,
                           std::unique_ptr<Part> fallback)
    : kernel_(kernel),
      fallback_(std::move(fallback)),
      tolerance_(settings.tolerance),
      inputs_(bound.inputs),
      constants_(bound.constants.size()),
      equations_(weights.size()) {
  const std::size_t branches = kernel.branches.size(),
                    folded = static_cast<std::size_t>(kernel.folded),
                    anchors = kernel.angles.size() * anchor_size;
  numbers_.resize(constants_ + folded + equations_ + 2 * branches + anchors);
  double *const c = numbers_.data(), *const f = c + constants_, *const w = f + folded;
  branch_ = w + equations_;
  branch_before_ = branch_ + branches;
  anchors_ = {branch_before_ + branches, anchors};
  std::ranges::copy(bound.constants, c);
  std::ranges::copy(weights, w);
  kernel_.fold(c, f);

  std::vector<bool> is_unknown(inputs_.size());
  for (const int input : kernel_.unknowns) is_unknown[input] = true;
  for (std::size_t i = 0; i < inputs_.size(); ++i)
    if (!is_unknown[i]) known_.push_back(inputs_[i]);
  at_end_.resize(known_.size());

  const double core_stop = core_share * settings.stop;
  binding_ = {.in = inputs_.data(),
              .c = c,
              .f = f,
              .branch = branch_,
              .w = w,
              .anchors = anchors_.data(),
              .limits = {.tolerance2 = settings.accept * settings.accept,
                         .core_tolerance2 = core_stop * core_stop,
                         .max_iterations = settings.max_iterations}};
}

[[gnu::always_inline]] inline ExplicitChainResult ExplicitPart::solve_generated(State& s,
                                                                                Level level) const {
  ExplicitKernel::Solve* const solve = kernel_.solve[static_cast<std::size_t>(level)];
  return solve(s.q.data(), s.qd.data(), s.qdd.data(), &binding_, 1);
}

PartResult ExplicitPart::solve(State& s, std::span<const double> last, Level level) {
  if (!assembled_) return fall_back(s, last, level);
  const ExplicitChainResult r = solve_generated(s, level);
  if (r.accepted == 0) return solve_refused(s, last, level);
  return {Status::solved, r.iterations, r.residual2};
}

/// Moves the known coordinates from the last position to the present one in equal steps, and the
/// torn unknowns by their rates (Euler's method). The velocity of a known coordinate is its whole
/// change, so that the way takes a unit of time. Returns whether the code accepts the position at
/// the beginning of each step.
bool ExplicitPart::continue_torn(State& s, std::span<const double> last, int steps) {
  for (std::size_t i = 0; i < known_.size(); ++i) {
    const int k = known_[i];
    at_end_[i] = {s.q[k], s.qd[k]};
    s.qd[k] = s.q[k] - last[k];
  }
  for (const int input : kernel_.unknowns) s.q[inputs_[input]] = last[inputs_[input]];
  bool accepted = true;
  for (int step = 0; step < steps && accepted; ++step) {
    for (const int k : known_) s.q[k] = last[k] + s.qd[k] * step / steps;
    accepted = solve_generated(s, Level::velocity).accepted == 1;
    for (const int input : kernel_.torn) s.q[inputs_[input]] += s.qd[inputs_[input]] / steps;
  }
  for (std::size_t i = 0; i < known_.size(); ++i) {
    s.q[known_[i]] = at_end_[i].q;
    s.qd[known_[i]] = at_end_[i].qd;
  }
  return accepted;
}

/// Not inlined: every step would have to save the registers that this function needs.
[[gnu::noinline]] PartResult ExplicitPart::solve_refused(State& s, std::span<const double> last,
                                                         Level level) {
  if (!kernel_.torn.empty())
    for (const int steps : torn_steps)
      if (continue_torn(s, last, steps))
        if (const ExplicitChainResult r = solve_generated(s, level); r.accepted == 1)
          return {Status::solved, r.iterations, r.residual2};
  ++fallbacks_;
  std::ranges::copy(branches(), branch_before_);
  const PartResult result = fall_back(s, last, level);
  branch_changes_ += !std::ranges::equal(branches(), std::span(branch_before_, branches().size()));
  return result;
}

[[gnu::noinline]] PartResult ExplicitPart::fall_back(State& s, std::span<const double> last,
                                                     Level level) {
  for (const int input : kernel_.unknowns) s.q[inputs_[input]] = last[inputs_[input]];
  const PartResult result = fallback_->solve(s, last, level);
  // After a fixed number of iterations a position may not have reached a branch yet.
  if (result.status == Status::solved && result.residual2 < tolerance_ * tolerance_) {
    kernel_.find_branches(s.q.data(), binding_.in, binding_.c, branch_);
    std::ranges::fill(anchors_, 0.0);
    assembled_ = true;
  }
  return result;
}

/// Returns the positions of some inputs in the state, ascending.
std::vector<int> ExplicitPart::in_state(std::span<const int> inputs) const {
  std::vector<int> result;
  for (const int input : inputs) result.push_back(inputs_[input]);
  std::ranges::sort(result);
  return result;
}

PartInputs ExplicitPart::inputs(PartInputs equations) const {
  return {.predicted = in_state(kernel_.torn),
          .unwrapped = in_state(kernel_.angles),
          .others = std::move(equations.others),
          .drivers = {}};
}

std::unique_ptr<PartChain> ExplicitPart::make_chain(std::span<Part* const> parts) {
  std::vector<const ExplicitPart*> alike;
  for (Part* const part : parts) {
    const auto* const next = dynamic_cast<const ExplicitPart*>(part);
    if (!next || &next->kernel_ != &kernel_) break;
    alike.push_back(next);
  }
  if (alike.size() < 2) return nullptr;
  return std::make_unique<ExplicitChain>(std::move(alike));
}

void ExplicitPart::forget() {
  assembled_ = false;
  fallback_->forget();
}

}  // namespace desmo
