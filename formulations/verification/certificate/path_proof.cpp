#include "formulations/verification/certificate/path_proof.h"

#include <algorithm>
#include <array>

#include "formulations/verification/certificate/block_schedule.h"
#include "formulations/verification/certificate/trial_box.h"

namespace desmo {

namespace {

constexpr double unit = Interval::unit;

}  // namespace

std::optional<double> first_knot(const Model& m, double from, double to) {
  std::optional<double> first;
  for (const Driver& d : m.drivers) {
    const Spline* spline = std::get_if<Spline>(&d.motion);
    if (!spline) continue;
    const auto begin = spline->knots().begin() + 1, end = spline->knots().end() - 1;
    const auto knot = std::upper_bound(begin, end, from);
    if (knot < end && *knot < to && (!first || *knot < *first)) first = *knot;
  }
  return first;
}

PathProof::PathProof(const Model& m, const Certifier& certifier)
    : m_(m), schedule_(certifier.schedule()), paths_(m.coordinates()) {
  const auto& [n, width, states, columns] = schedule_->largest;
  states_.resize(states), slopes_.resize(states), curved_.resize(states);
  phi_.resize(n);
  errors_.resize(width);
  for (auto* values : {&gaps_, &image_, &uncertainty_, &trial_, &contracted_}) values->resize(n);
  preconditioner_.resize(n, width);
}

/// Takes the paths, gaps and errors of a batch's states.
void PathProof::gather(const BlockBatch& b) {
  const BlockShape& shape = b.equations.shape();
  const int n = shape.unknowns;
  const CoordinatePath* const rows = paths_.data();
  b.equations.write_fixed(states_.data());
  for (int j = 0; j < shape.width(); ++j) {
    const int* const at = &b.coordinates[LaneNumbers::count * j];
    const double *p0 = rows[at[0]].path.data(), *p1 = rows[at[1]].path.data(),
                 *p2 = rows[at[2]].path.data(), *p3 = rows[at[3]].path.data();
    const auto load = [&](LaneNumbers* to) {
      for (const double** p : {&p0, &p1, &p2, &p3}) {
        *to++ = LaneNumbers::load(*p);
        *p += LaneNumbers::count;
      }
      transpose(to[-4], to[-3], to[-2], to[-1]);
    };
    PathValue& x = states_[b.locals[j]];
    x.rest = 0;
    load(x.c.data());
    std::array<LaneNumbers, 4> high;
    load(high.data());
    x.c[4] = high[0], x.c[5] = high[1];
    if (j < n)
      gaps_[j] = high[2];
    else
      errors_[j - n] = high[3];
  }
  if (shape.linear) return;
  for (int i = 0; i < shape.states(); ++i) {
    const PathValue& x = states_[i];
    LaneNumbers rest = x.rest;
    for (int k = 2; k <= path_degree; ++k) rest += abs(x.c[k]);
    curved_[i] = rest * (1 + 8 * unit);
    slopes_[i].c = {x.c[0], x.c[1]};
    slopes_[i].rest = curved_[i];
  }
  for (int j = n; j < shape.width(); ++j) slopes_[b.locals[j]].rest += errors_[j - n];
}

/// Subtracts (1 − t) Φ₀ from Φ along the path, on which the time t is a function of s.
void PathProof::add_homotopy(const BlockBatch& b) {
  PathValue time(span_.middle), one(1);
  time.c[1] = span_.half;
  for (int r = 0; r < b.equations.shape().unknowns; ++r) {
    PathValue initial;
    initial.c[0] = b.initial[r];
    phi_[r] = phi_[r] - (one - time) * initial;
  }
}

/// Bounds |Y Φ + Y Φ_h δ| for all s.
void PathProof::find_image(const BlockBatch& b) {
  const BlockShape& shape = b.equations.shape();
  const int n = shape.unknowns, m = shape.inputs;
  b.equations.residual(states_.data(), phi_.data());
  if (!b.initial.empty()) add_homotopy(b);
  for (int r = 0; r < n; ++r) {
    LaneNumbers sum = phi_[r].magnitude();
    for (int k = shape.input_begins[r]; k < shape.row_begins[r + 1]; ++k)
      sum = fma(fma(b.rounding, abs(b.jacobian.mid[k]), b.jacobian.radius[k]),
                errors_[shape.entries[k] - n], sum);
    uncertainty_[r] = sum;
  }
  for (int i = 0; i < n; ++i) {
    LaneNumbers sum(0);
    for (int r = 0; r < n; ++r) sum = fma(abs(y_->inverse[i * n + r]), uncertainty_[r], sum);
    for (int j = 0; j < m; ++j) sum = fma(y_->slopes[i * m + j], errors_[j], sum);
    image_[i] = sum * (1 + b.rounding);
  }
}

/// Bounds |(I − Y Φ_φ(X)) X| for the radii of X.
void PathProof::contract(BlockBatch& b) {
  const BlockShape& shape = b.equations.shape();
  const int n = shape.unknowns;
  if (!shape.linear) {
    for (int i = 0; i < n; ++i) slopes_[b.locals[i]].rest = curved_[b.locals[i]] + trial_[i];
    b.equations.jacobian(slopes_.data(), b.jacobian);
  }
  desmo::contract(b, *y_, trial_.data(), uncertainty_.data(), contracted_.data());
  for (int i = 0; i < n; ++i) contracted_[i] *= 1 + b.rounding;
}

/// Returns in which lanes the tubes of a batch are proven, and writes their radii.
LaneMask PathProof::prove(BlockBatch& b) {
  const BlockShape& shape = b.equations.shape();
  const int n = shape.unknowns;
  gather(b);
  if (!shape.linear) {
    b.equations.jacobian(slopes_.data(), b.jacobian);  // with the inputs' errors δ, and X = 0
    preconditioner_.find(shape, b.jacobian.mid.data(), LaneMask::all());
  }
  y_ = shape.linear ? &b.constant : &preconditioner_;
  find_image(b);
  std::fill_n(contracted_.begin(), n, LaneNumbers(0));
  LaneMask proven{};
  for (int attempt = 0; attempt < max_trial_boxes && (!proven).any(); ++attempt) {
    for (int i = 0; i < n; ++i)
      trial_[i] = max(gaps_[i], inflated(image_[i] + contracted_[i], b.magnitudes[i]));
    contract(b);
    proven = LaneMask::all();
    for (int i = 0; i < n; ++i) proven = proven & less(image_[i] + contracted_[i], trial_[i]);
  }
  for (int i = 0; i < n; ++i) {
    const LaneNumbers radius = (image_[i] + contracted_[i]) * (1 + 4 * unit);
    for (int lane = 0; lane < b.size(); ++lane)
      if (proven[lane]) paths_[b.coordinates[LaneNumbers::count * i + lane]].radius = radius[lane];
  }
  return proven;
}

PathCertificate PathProof::prove(const CertifiedInstant& from, const CertifiedInstant& to) {
  if (first_knot(m_, from.time, to.time)) return {};
  find_paths(from, to);
  find_driven_paths();
  for (CertificationStep& step : schedule_->steps)
    for (BlockBatch& b : step.batches) {
      const LaneMask proven = prove(b);
      for (int lane = 0; lane < b.size(); ++lane)
        if (!proven[lane]) return {.group = b.blocks[lane].group};
    }
  return {.proven = true};
}

double PathProof::centre(int coordinate, double time) const {
  return value_at(path(coordinate), span_.s(time));
}

}  // namespace desmo
