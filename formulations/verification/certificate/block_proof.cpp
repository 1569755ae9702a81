#include "formulations/verification/certificate/block_proof.h"

#include <cmath>

#include "formulations/verification/certificate/trial_box.h"

namespace desmo {

namespace {

LaneNumbers loaded(const ErrorTable::Row& row) {
  return LaneNumbers::load(&row.delivered);  // all four numbers of the row
}

}  // namespace

BlockProof::BlockProof(const BatchSizes& largest) {
  const int n = largest.unknowns;
  for (const Level level : all_levels) {
    state_[level].resize(largest.states);
    phi_[level].resize(n);
    rates_[level].resize(n * largest.width);
    ErrorColumns& e = errors_[level];
    for (auto* values : {&e.centre, &e.own, &e.sum, &e.weight}) values->resize(largest.width);
  }
  preconditioner_.resize(n, largest.width);
  for (auto* values : {&centre_, &uncertainty_, &trial_, &contracted_}) values->resize(n);
  generators_.resize(n * largest.columns);
  lower_.reserve(2);
}

/// Takes the delivered numbers of all states and the errors of the inputs. Returns in which lanes
/// these errors are all bounded.
LaneMask BlockProof::gather(Level level, const ErrorTable& errors) {
  const BlockBatch& b = *batch_;
  LaneInterval* x = state_[level].data();
  ErrorColumns& e = errors_[level];
  const int* at = b.states.data();
  for (const int i : b.plain) {
    x[i] = {LaneNumbers(
                LaneNumbers::Numbers{errors.rows[at[0]].delivered, errors.rows[at[1]].delivered,
                                     errors.rows[at[2]].delivered, errors.rows[at[3]].delivered}),
            level == Level::position ? b.equations.radius(i) : LaneNumbers(0)};
    at += LaneNumbers::count;
  }
  LaneNumbers all(0);
  for (int j = shape_->unknowns; j < shape_->width(); ++j) {
    const int* row = &b.rows[LaneNumbers::count * j];
    LaneNumbers delivered = loaded(errors.rows[row[0]]), centre = loaded(errors.rows[row[1]]),
                own = loaded(errors.rows[row[2]]), sum = loaded(errors.rows[row[3]]);
    transpose(delivered, centre, own, sum);
    e.centre[j] = centre;
    e.own[j] = own;
    e.sum[j] = sum;
    all += sum;
    // Rates have no radius yet: bound_rates() takes derivatives at the delivered rates of its
    // level. finish() then sets the radii for the next level.
    x[b.locals[j]] = {delivered, level == Level::position ? sum : LaneNumbers(0)};
  }
  return is_finite(all);
}

/// Adds to the errors of the unknowns what X causes: factor × contracted_. Then sets the weights
/// and radii that the next level reads.
void BlockProof::finish(Level level, const LaneNumbers& factor) {
  ErrorColumns& e = errors_[level];
  for (int i = 0; i < shape_->unknowns; ++i) {
    const LaneNumbers more = contracted_[i] * factor;
    e.own[i] += more;
    e.sum[i] += more;
  }
  if (shape_->linear || level == up_to_) return;  // no level reads what follows
  for (int j = 0; j < shape_->width(); ++j) {
    e.weight[j] = fma(batch_->rounding, e.sum[j], e.own[j]);
    state_[level][batch_->locals[j]].radius = e.sum[j];
  }
}

LaneMask BlockProof::prove_positions(PerLevel<ErrorTable>& all, LaneMask lanes) {
  BlockBatch& b = *batch_;
  const bool linear = shape_->linear;
  const int n = shape_->unknowns;
  ErrorColumns& e = errors_.position;
  lower_.clear();
  y_ = linear ? &b.constant : &preconditioner_;
  if (linear) find_image(Level::position, all);
  LaneMask proven{};
  for (int attempt = 0; attempt < max_trial_boxes && (lanes & !proven).any(); ++attempt) {
    for (int i = 0; i < n; ++i) {
      // Trial radii are never zero: bound_rates() divides by them.
      const LaneNumbers last = attempt < 2 ? LaneNumbers(0) : 2 * contracted_[i];
      const LaneNumbers trial = attempt == 0 && !linear
                                    ? b.magnitudes[i] * first_trial
                                    : inflated(e.sum[i] + last, b.magnitudes[i]);
      trial_[i] = select(proven, trial_[i], trial);
      state_.position[b.locals[i]].radius = trial_[i];
    }
    if (!linear) {
      // Midpoints do not depend on the radii, so that Y of the first attempt serves all.
      b.equations.jacobian(state_.position.data(), b.jacobian);
      if (attempt == 0) {
        preconditioner_.find(*shape_, b.jacobian.mid.data(), lanes);
        condition_ = preconditioner_.condition(*shape_, b.jacobian.mid.data(), b.magnitudes.data());
      }
      find_image(Level::position, all);
    }
    contract(b, *y_, trial_.data(), uncertainty_.data(), contracted_.data());
    LaneMask inside = lanes;
    for (int i = 0; i < n; ++i) inside = inside & less(fma(2, contracted_[i], e.sum[i]), trial_[i]);
    proven = proven | inside;
  }
  finish(Level::position, 1);
  condition_ = select(lanes, linear ? b.condition : condition_, 0);
  return proven;
}

LaneMask BlockProof::bound_rates(Level level, PerLevel<ErrorTable>& all, LaneMask lanes) {
  const BlockBatch& b = *batch_;
  lower_.clear();
  if (!shape_->linear) {
    // Encloses Φ̇_q over the errors of positions, at the delivered velocities. For accelerations,
    // also encloses Φ̈_q over the errors of positions and velocities, at the delivered
    // accelerations. Terms of `lower_` are linear in the errors of lower levels, so the rates of
    // this level need no radius.
    b.equations.jacobian_rates(state_, level, rates_);
    lower_.push_back({level, 1, Level::position});
    if (level == Level::acceleration) lower_.push_back({Level::velocity, 2, Level::velocity});
  }
  find_image(level, all);
  // Let ε be the errors, b = e.sum as find_image() left it, r = trial_ and A = |I − Y Φ_φ(X)|. Then
  // ε ≤ b + A ε. Positions are proven, so A r ≤ r/2. Hence ε ≤ 2 max(b/r) r, and
  // ε ≤ b + 2 max(b/r) A r.
  const ErrorColumns& e = errors_[level];
  LaneNumbers ratio(0);
  for (int i = 0; i < shape_->unknowns; ++i) ratio = max(ratio, e.sum[i] / trial_[i]);
  finish(level, 2 * ratio);
  for (int i = 0; i < shape_->unknowns; ++i) lanes = lanes & is_finite(e.sum[i]);
  return lanes;
}

/// Writes the errors of the unknowns to the table. Lanes that were not tried have unknown errors.
void BlockProof::scatter(Level level, LaneMask tried, LaneMask proven, ErrorTable& to) const {
  const BlockBatch& b = *batch_;
  const ErrorColumns& e = errors_[level];
  const int blocks = b.size();
  for (int i = 0; i < shape_->unknowns; ++i) {
    const int* const row = &b.rows[LaneNumbers::count * i];
    const int coordinate = b.coordinates[LaneNumbers::count * i];
    // An infinite sum leaves the blocks that read it unproven, too.
    LaneNumbers a = state_[level][b.locals[i]].mid,
                centre = select(tried & is_finite(e.centre[i]), e.centre[i], 0), c = e.own[i],
                d = select(proven, e.sum[i], INFINITY);
    transpose(a, centre, c, d);
    a.store(&to.rows[row[0]].delivered);
    if (blocks > 1) centre.store(&to.rows[row[1]].delivered);
    if (blocks > 2) c.store(&to.rows[row[2]].delivered);
    if (blocks > 3) d.store(&to.rows[row[3]].delivered);
    if (row[0] == coordinate) continue;
    // The row of the coordinate has no symbols: its own radius takes up their part.
    ErrorTable::Row& box = to.rows[coordinate] = to.rows[row[0]];
    box.own = box.sum - std::abs(box.centre);
  }
}

/// Subtracts (1 − t) Φ₀ from Φ, and the time derivative of that term, −Φ₀, from Φ̇.
void BlockProof::add_homotopy(Level up_to, double time) {
  const LaneInterval share = LaneInterval(1) - LaneInterval(time);
  for (int r = 0; r < shape_->unknowns; ++r) {
    const LaneInterval initial(batch_->initial[r], 0);
    phi_.position[r] = phi_.position[r] - share * initial;
    if (up_to >= Level::velocity) phi_.velocity[r] = phi_.velocity[r] + initial;
  }
}

PerLevel<LaneMask> BlockProof::prove(BlockBatch& batch, Level up_to, PerLevel<ErrorTable>& errors,
                                     double time) {
  batch_ = &batch;
  up_to_ = up_to;
  shape_ = &batch.equations.shape();
  PerLevel<LaneMask> are_inputs_known;
  for (const Level level : all_levels)
    if (level <= up_to) are_inputs_known[level] = gather(level, errors[level]);
  batch.equations.motion(state_, up_to, phi_);
  if (!batch.initial.empty()) add_homotopy(up_to, time);
  PerLevel<LaneMask> proven;
  LaneMask lanes = LaneMask::all();
  condition_ = 0;
  for (const Level level : all_levels) {
    if (level > up_to) break;
    lanes = lanes & are_inputs_known[level];  // lanes with unbounded inputs would fail later anyway
    const LaneMask tried = lanes;
    if (lanes.any())
      lanes = level == Level::position ? prove_positions(errors, lanes)
                                       : bound_rates(level, errors, lanes);
    scatter(level, tried, lanes, errors[level]);
    proven[level] = lanes;
  }
  return proven;
}

}  // namespace desmo
