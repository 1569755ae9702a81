#include "formulations/verification/certificate/block_proof.h"

#include <algorithm>
#include <cmath>

namespace desmo {

namespace {

Lanes gathered(const double* from, const int* index) {
  return Lanes(Lanes::Numbers{from[index[0]], from[index[1]], from[index[2]], from[index[3]]});
}

}  // namespace

BlockProof::BlockProof(int n, int m, int states, int columns) {
  const int w = n + m;
  for (const Level level : levels) {
    state_[level].resize(states);
    phi_[level].resize(n);
    rates_[level].resize(n * w);
    for (auto* values : {&errors_[level].center, &errors_[level].own, &errors_[level].sum})
      values->resize(w);
  }
  preconditioner_.resize(n, m);
  for (auto* values : {&center_, &uncertainty_, &trial_, &contracted_}) values->resize(n);
  generators_.resize(n * columns);
  lower_.reserve(2);
}

/// Takes the delivered numbers and the errors of the inputs.
void BlockProof::gather(Level level, const std::vector<double>& delivered,
                        const ErrorTable& errors) {
  const BlockBatch& b = *batch_;
  std::vector<LaneInterval>& x = state_[level];
  for (int i = 0; i < b.equations.shape().states(); ++i)
    x[i] = {gathered(delivered.data(), &b.states[Lanes::count * i]), Lanes(0)};
  Errors& e = errors_[level];
  for (int j = 0; j < n(); ++j) e.center[j] = e.own[j] = e.sum[j] = Lanes(0);
  for (int j = n(); j < width(); ++j) {
    const int* row = &b.rows[Lanes::count * j];
    e.center[j] = gathered(errors.center.data(), row);
    e.own[j] = gathered(errors.own.data(), row);
    e.sum[j] = gathered(errors.sum.data(), row);
    x[b.locals[j]].radius = gathered(errors.sum.data(), &b.coordinates[Lanes::count * j]);
  }
}

LaneMask BlockProof::known_inputs(Level level) const {
  Lanes sum(0);
  for (int j = n(); j < width(); ++j) sum += errors_[level].sum[j];
  for (int j = 0; j < width(); ++j) sum += abs(state_[level][batch_->locals[j]].mid) * 0.0;
  return is_finite(sum);
}

/// Finds the errors of the unknowns but for those that X causes: −Y Φ − Y Φ_h δ, and at higher
/// levels −Y times the lower terms.
template <int N>
void BlockProof::find_image(Level level) {
  const BlockBatch& b = *batch_;
  const BlockShape& shape = b.equations.shape();
  const int n = N > 0 ? N : shape.unknowns, m = shape.inputs;
  const Lanes rounding = b.rounding;
  Errors& e = errors_[level];
  for (int r = 0; r < n; ++r) {
    const LaneInterval& f = phi_[level][r];
    Lanes center = f.mid, uncertain = fma(rounding, abs(f.mid), f.radius);
    const int row_end = shape.row_begins[r + 1];
    for (int k = shape.input_begins[r]; k < row_end; ++k) {
      const int j = shape.entries[k];
      const Lanes &mid = b.jacobian.mid[k], &radius = b.jacobian.radius[k];
      center = fma(mid, e.center[j], center);
      uncertain = fma(fma(rounding, abs(mid), radius), e.sum[j], uncertain);
    }
    for (const LowerTerm& term : lower_) {
      const Errors& lower = errors_[term.errors];
      const LaneMatrix& derivative = rates_[term.derivative];
      Lanes of_center(0), of_own(0);
      for (int k = shape.row_begins[r]; k < row_end; ++k) {
        const int j = shape.entries[k];
        const Lanes &mid = derivative.mid[k], &radius = derivative.radius[k];
        of_center = fma(mid, lower.center[j], of_center);
        of_own = fma(fma(rounding, abs(mid), radius), lower.sum[j], of_own);
        of_own = fma(abs(mid), lower.own[j], of_own);
      }
      center = fma(of_center, term.factor, center);
      uncertain = fma(of_own, term.factor, uncertain);
    }
    center_[r] = center;
    uncertainty_[r] = uncertain;
  }
  for (int i = 0; i < n; ++i) {
    Lanes center(0), own(Interval::tiny);
    for (int r = 0; r < n; ++r) {
      center = fma(-y_->inverse[i * n + r], center_[r], center);
      own = fma(abs(y_->inverse[i * n + r]), uncertainty_[r], own);
    }
    for (int j = 0; j < m; ++j) own = fma(y_->slopes[i * m + j], e.own[n + j], own);
    e.center[i] = center;
    e.own[i] = own * (Lanes(1) + rounding);
    e.sum[i] = (abs(center) + e.own[i]) * (Lanes(1) + rounding);
  }
}

/// Finds the symbols of the unknowns in the same way.
void BlockProof::find_generators(Level level, PerLevel<ErrorTable>& errors) {
  const BlockBatch& b = *batch_;
  ErrorTable& to = errors[level];
  const BlockShape& s = b.equations.shape();
  const int n = s.unknowns, columns = to.columns;
  std::fill_n(generators_.begin(), n * columns, 0);
  const auto add = [&](const LaneMatrix& derivative, double factor, bool inputs, Level from) {
    for (int r = 0; r < n; ++r)
      for (int e = inputs ? s.input_begins[r] : s.row_begins[r]; e < s.row_begins[r + 1]; ++e) {
        const int row = b.rows[Lanes::count * s.entries[e]];
        const double t = factor * derivative.mid[e][0];
        if (t == 0 || !errors[from].has_generators(row)) continue;
        const double* image = errors[from].of_row(row);
        double* generators = &generators_[r * columns];
#pragma omp simd
        for (int k = 0; k < columns; ++k) generators[k] += t * image[k];
      }
  };
  add(b.jacobian, 1, true, level);
  for (const LowerTerm& t : lower_) add(rates_[t.derivative], t.factor, false, t.errors);
  for (int i = 0; i < n; ++i) {
    double* generators = to.of_row(b.rows[Lanes::count * i]);
    std::fill_n(generators, columns, 0);
    double sum = 0;
    for (int r = 0; r < n; ++r) {
      const double y = y_->inverse[i * n + r][0];
#pragma omp simd
      for (int k = 0; k < columns; ++k) generators[k] -= y * generators_[r * columns + k];
    }
#pragma omp simd reduction(+ : sum)
    for (int k = 0; k < columns; ++k) sum += std::abs(generators[k]);
    Lanes& all = errors_[level].sum[i];
    all = (all + sum) * (Lanes(1) + b.rounding);
  }
}

/// Bounds |(I − Y Φ_φ(X)) X| by the radii of X.
template <int N>
void BlockProof::contract() {
  const BlockBatch& b = *batch_;
  const BlockShape& s = b.equations.shape();
  const int n = N > 0 ? N : s.unknowns;
  const Lanes rounding = b.rounding;
  for (int r = 0; r < n; ++r) {
    Lanes sum(0);
    for (int e = s.row_begins[r]; e < s.input_begins[r]; ++e)
      sum = fma(fma(rounding, abs(b.jacobian.mid[e]), b.jacobian.radius[e]), trial_[s.entries[e]],
                sum);
    uncertainty_[r] = sum;
  }
  for (int i = 0; i < n; ++i) {
    Lanes sum = fma(rounding, trial_[i], Interval::tiny);  // what is left of 1 was rounded
    for (int r = 0; r < n; ++r) {
      sum = fma(y_->remainder[i * n + r], trial_[r], sum);
      sum = fma(abs(y_->inverse[i * n + r]), uncertainty_[r], sum);
    }
    contracted_[i] = sum * (Lanes(1) + rounding);
  }
}

/// Gives the unknowns their radii.
void BlockProof::widen(Level level) {
  for (int i = 0; i < n(); ++i) state_[level][batch_->locals[i]].radius = errors_[level].sum[i];
}

void BlockProof::add_contraction(Level level, const Lanes& factor) {
  Errors& e = errors_[level];
  const Lanes up = Lanes(1) + batch_->rounding;
  for (int i = 0; i < n(); ++i) {
    const Lanes more = contracted_[i] * factor;
    e.own[i] = (e.own[i] + more) * up;
    e.sum[i] = (e.sum[i] + more) * up;
  }
}

LaneMask BlockProof::prove_positions(PerLevel<ErrorTable>& all, LaneMask lanes) {
  BlockBatch& b = *batch_;
  const Lanes up = Lanes(1) + b.rounding;
  Errors& e = errors_.position;
  const auto image = [&] {
    n() == 1   ? find_image<1>(Level::position)
    : n() == 3 ? find_image<3>(Level::position)
               : find_image<0>(Level::position);
    if (all.position.columns > 0) find_generators(Level::position, all);
  };
  lower_.clear();
  y_ = b.equations.is_linear() ? &b.constant : &preconditioner_;
  if (b.equations.is_linear()) image();
  LaneMask proven{};
  constexpr int attempts = 7;
  for (int attempt = 0; attempt < attempts && (lanes & !proven).any(); ++attempt) {
    const bool wide = attempt == 0 && !b.equations.is_linear();
    for (int i = 0; i < n(); ++i) {
      // First, X is so large that one evaluation will do, and so small that it costs no digits.
      // Then it is larger than what the last test returned (epsilon inflation; Rump). A part of the
      // magnitude serves errors that are exactly zero.
      const Lanes last = attempt <= 1 ? Lanes(0) : contracted_[i];
      const Lanes trial =
          wide ? b.magnitudes[i] * 0x1p-36 : (e.sum[i] + last) * 1.1 + b.magnitudes[i] * 0x1p-60;
      trial_[i] = select(proven, trial_[i], trial);
      state_.position[b.locals[i]].radius = trial_[i];
    }
    if (!b.equations.is_linear()) {
      b.equations.jacobian(state_.position.data(), b.jacobian);  // with the same midpoints
      if (attempt == 0) preconditioner_.find(b.equations.shape(), b.jacobian.mid.data(), lanes);
      image();
    }
    n() == 1 ? contract<1>() : n() == 3 ? contract<3>() : contract<0>();
    LaneMask inside = lanes;
    for (int i = 0; i < n(); ++i) {
      inside = inside & less((e.sum[i] + contracted_[i]) * up, trial_[i]);
      if (wide)
        inside = inside & less(contracted_[i], e.sum[i] * 0x1p-6 + b.magnitudes[i] * 0x1p-64);
    }
    proven = proven | inside;
  }
  add_contraction(Level::position, 1);
  widen(Level::position);
  return proven;
}

LaneMask BlockProof::bound_rates(Level level, PerLevel<ErrorTable>& all, LaneMask lanes) {
  const BlockBatch& b = *batch_;
  lower_.clear();
  if (!b.equations.is_linear()) {
    // Φ̇_q and Φ̈_q within the errors of all lower levels, at the delivered rates of this one.
    const std::size_t entries = b.equations.shape().entries.size();
    PerLevel<const LaneInterval*> x;
    for (const Level l : levels) x[l] = state_[l].data();
    for (const Level l : levels)
      if (l != Level::position && l <= level) {
        std::fill_n(rates_[l].mid.begin(), entries, Lanes(0));
        std::fill_n(rates_[l].radius.begin(), entries, Lanes(0));
      }
    b.equations.jacobian_rates(x, level, rates_);
    lower_.push_back({level, 1, Level::position});
    if (level == Level::acceleration) lower_.push_back({Level::velocity, 2, Level::velocity});
  }
  n() == 1 ? find_image<1>(level) : n() == 3 ? find_image<3>(level) : find_image<0>(level);
  if (all[level].columns > 0) find_generators(level, all);
  // With A = |I − Y Φ_φ(X)| and A r ≤ η r, errors e ≤ b + A e are at most b + A r max(b/r)/(1 − η).
  Lanes ratio(0), contraction(0);
  for (int i = 0; i < n(); ++i) {
    ratio = max(ratio, errors_[level].sum[i] / trial_[i]);
    contraction = max(contraction, contracted_[i] / trial_[i]);
  }
  const Lanes margin = Lanes(1) - contraction - Lanes(b.rounding);
  LaneMask proven = lanes & less(0, margin);
  add_contraction(level, ratio / margin * (Lanes(1) + b.rounding));
  for (int i = 0; i < n(); ++i) proven = proven & is_finite(errors_[level].sum[i]);
  widen(level);
  return proven;
}

void BlockProof::scatter(Level level, LaneMask proven, ErrorTable& to) const {
  const BlockBatch& b = *batch_;
  const Errors& e = errors_[level];
  for (int lane = 0; lane < b.blocks(); ++lane)
    for (int i = 0; i < n(); ++i) {
      const int row = b.rows[Lanes::count * i + lane];
      const int coordinate = b.coordinates[Lanes::count * i + lane];
      if (!proven[lane]) {  // whoever reads it is not proven either
        to.set(row, 0, 0, INFINITY);
        to.set(coordinate, 0, 0, INFINITY);
        if (to.has_generators(row)) std::fill_n(to.of_row(row), to.columns, 0);
        continue;
      }
      const double center = e.center[i][lane], sum = e.sum[i][lane];
      double own = e.own[i][lane];
      to.set(row, center, own, sum);
      if (row == coordinate) continue;
      for (int k = 0; k < to.columns; ++k) own += std::abs(to.of_row(row)[k]);
      to.set(coordinate, center, own * (1 + b.rounding), sum);
    }
}

PerLevel<LaneMask> BlockProof::prove(BlockBatch& batch,
                                     const PerLevel<std::vector<double>>& delivered, Level up_to,
                                     PerLevel<ErrorTable>& errors) {
  batch_ = &batch;
  PerLevel<const LaneInterval*> x;
  PerLevel<LaneInterval*> phi;
  for (const Level level : levels) {
    if (level <= up_to) gather(level, delivered[level], errors[level]);
    x[level] = state_[level].data();
    phi[level] = phi_[level].data();
  }
  batch.equations.motion(x, up_to, phi);
  PerLevel<LaneMask> proven;
  LaneMask lanes = LaneMask::all();
  for (const Level level : levels) {
    if (level > up_to) break;
    lanes = lanes & known_inputs(level);
    if (level > Level::position) {  // the derivatives are those of the delivered rates
      for (int j = 0; j < width(); ++j) state_[level][batch.locals[j]].radius = Lanes(0);
    }
    lanes = !lanes.any()               ? lanes
            : level == Level::position ? prove_positions(errors, lanes)
                                       : bound_rates(level, errors, lanes);
    if (level > Level::position && level < up_to)
      for (int j = n(); j < width(); ++j)
        state_[level][batch.locals[j]].radius =
            gathered(errors[level].sum.data(), &batch.coordinates[Lanes::count * j]);
    scatter(level, lanes, errors[level]);
    proven[level] = lanes;
  }
  return proven;
}

}  // namespace desmo
