#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "formulations/formulation.h"

namespace desmo {

/// A formulation that, in a motion, solves every stride-th instant and the last one, and
/// interpolates the others (see DenseOutput). Single instants are solved by the formulation inside.
class Interpolated final : public Formulation {
 public:
  /// stride: 2 … max_stride.
  Interpolated(std::unique_ptr<Formulation> inner, int stride);

  Summary assemble(double t, Level level) override { return inner_->assemble(t, level); }
  Summary step(double t, Level level) override { return inner_->step(t, level); }
  Summary run(const TimeGrid& grid, const Request& request, Observer& observer) override;
  bool start_at(std::span<const double> q, double t) override { return inner_->start_at(q, t); }
  std::optional<Summary> run_on(const TimeGrid& grid, const Request& request,
                                Observer& observer) override {
    return inner_->run_on(grid, request, observer);
  }
  void solve_only(std::span<const Level>) override {}
  long run_by_steps() const override { return inner_->run_by_steps(); }
  const std::vector<DefinedPart>& parts() const override { return inner_->parts(); }
  const State& state() const override { return inner_->state(); }

 private:
  std::unique_ptr<Formulation> inner_;
  int stride_;
};

}  // namespace desmo
