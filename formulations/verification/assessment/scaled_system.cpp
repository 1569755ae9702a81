#include "formulations/verification/assessment/scaled_system.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "formulations/algebra/klu_factors.h"
#include "formulations/scaling/characteristic_lengths.h"
#include "formulations/scaling/scales.h"

namespace desmo {

ScaledSystem::ScaledSystem(const Model& m, Norm norm)
    : model_(m),
      norm_(norm),
      equations_(m),
      magnitude_(norm == Norm::of_blocks ? CharacteristicLengths(m).of_coordinates()
                                         : natural_magnitudes(m)),
      of_whole_(natural_magnitudes(m)),
      driver_change_(m.state_size()),
      row_sums_(equations_.rows()),
      by_drivers_(equations_.rows()),
      sensitivities_(equations_.rows()),
      unknown_shares_(equations_.rows()),
      row_shares_(equations_.rows()),
      block_row_sums_(equations_.rows()) {
  unsigned bits = 0;  // signs without a pattern, so that drivers hardly ever cancel
  for (const Driver& d : m.drivers) {
    const int i = m.entities[d.coordinate].first;
    bits += 2654435769u;
    driver_change_[i] = bits >> 31 ? -magnitude_[i] : magnitude_[i];
  }
  for (const Constraint& c : m.constraints)
    row_groups_.insert(row_groups_.end(), kept_rows(c), c.group);
  lay_out();
  state_.reserve(m.state_size());
  for (int j = 0; j < size(); ++j)
    unknown_shares_[j] = magnitude_[unknowns()[j]] / of_whole_[unknowns()[j]];
  if (size() == 0) return;
  factors_ = std::make_unique<KluFactors>(pattern_);
  orientation_.resize(factors_->block_start().size() - 1);
  counted_.resize(size());
  block_.resize(size());
  block_size_.resize(size());
  const auto start = factors_->block_start(), columns = factors_->block_columns();
  for (std::size_t b = 0; b < orientation_.size(); ++b)
    for (int i = start[b]; i < start[b + 1]; ++i) {
      block_[columns[i]] = static_cast<int>(b);
      block_size_[columns[i]] = start[b + 1] - start[b];
    }
  place_of_row_.resize(size());
  for (int i = 0; i < size(); ++i) place_of_row_[factors_->block_rows()[i]] = i;
}

ScaledSystem::~ScaledSystem() = default;

void ScaledSystem::solve(double* x, int right_sides) { factors_->solve_all(x, right_sides); }
void ScaledSystem::solve_blocks(double* x, int right_sides) {
  if (norm_ == Norm::of_whole) return solve(x, right_sides);
  factors_->solve_blocks(x, right_sides);
}
void ScaledSystem::solve_transposed(double* x, int right_sides) {
  factors_->solve_transposed(x, right_sides);
}
void ScaledSystem::solve_blocks_transposed(double* x, int right_sides) {
  if (norm_ == Norm::of_whole) return solve_transposed(x, right_sides);
  factors_->solve_blocks_transposed(x, right_sides);
}

std::vector<double> ScaledSystem::magnitudes_at(std::span<const double> q) const {
  return norm_ == Norm::of_blocks ? CharacteristicLengths(model_, q).of_coordinates() : of_whole_;
}

GroupId ScaledSystem::group_of_block(int block) const {
  return row_groups_[factors_->block_rows()[factors_->block_start()[block]]];
}

double ScaledSystem::log_determinant(int block) const {
  const auto start = factors_->block_start(), rows = factors_->block_rows();
  const auto pivots = factors_->pivot_values();
  double log = 0;
  for (int i = start[block]; i < start[block + 1]; ++i)
    log += std::log(std::abs(pivots[i]) * row_sums_[rows[i]]);
  return log;
}

void ScaledSystem::lay_out() {
  struct Entry {
    int column, row, emitted;
  };
  std::vector<Entry> entries;
  const std::vector<double> any(driver_change_.size(), 1);
  equations_.jacobian<double>(any, [&](int row, int i, double) {
    if (const int column = equations_.column(i); column >= 0)
      entries.push_back({column, row, static_cast<int>(slots_.size())});
    slots_.push_back(-1);
  });
  std::ranges::sort(entries, {}, [](const Entry& e) {
    return static_cast<std::int64_t>(e.column) << 32 | e.row;
  });
  pattern_.n = equations_.rows();
  pattern_.unknowns = equations_.unknowns();
  pattern_.column_start.assign(pattern_.n + 1, 0);
  for (const Entry& e : entries) {
    slots_[e.emitted] = static_cast<int>(pattern_.row.size());
    pattern_.row.push_back(e.row);
    ++pattern_.column_start[e.column + 1];
  }
  for (int j = 0; j < pattern_.n; ++j) pattern_.column_start[j + 1] += pattern_.column_start[j];
  values_.resize(pattern_.row.size());
}

bool ScaledSystem::factor(std::span<const double> state) {
  if (std::ranges::equal(state, state_)) return true;
  state_.clear();
  row_sums_.setZero();
  row_shares_.setZero();
  by_drivers_.setZero();
  auto slot = slots_.begin();
  equations_.jacobian<double>(state, [&](int row, int i, double value) {
    if (const int at = *slot++; at >= 0) {
      values_[at] = value * magnitude_[i];
      row_sums_[row] += std::abs(values_[at]);
      row_shares_[row] += std::abs(value) * of_whole_[i];
    } else {
      by_drivers_[row] += value * driver_change_[i];
    }
  });
  row_sums_ = (row_sums_ > 0).select(row_sums_, 1.0);
  row_shares_ /= row_sums_;
  by_drivers_ /= row_sums_;
  for (std::size_t k = 0; k < values_.size(); ++k) values_[k] /= row_sums_[pattern_.row[k]];
  if (factors_ && !factors_->factor(values_.data())) return false;
  orient();
  state_.assign(state.begin(), state.end());
  return true;
}

GroupId ScaledSystem::singular_group() const {
  const int column = std::clamp(factors_->singular_column(), 0, size() - 1);
  return row_groups_[pattern_.row[pattern_.column_start[column]]];
}

const ScaledSystem::Array& ScaledSystem::sensitivities() {
  sensitivities_ = by_drivers_;
  if (factors_) factors_->solve(sensitivities_.data());
  return sensitivities_;
}

const ScaledSystem::Array& ScaledSystem::block_row_sums() {
  if (norm_ == Norm::of_whole) return block_row_sums_.setOnes();
  block_row_sums_.setZero();
  for (int j = 0; j < size(); ++j)
    for (int k = pattern_.column_start[j]; k < pattern_.column_start[j + 1]; ++k)
      if (const int row = pattern_.row[k];
          block_[factors_->block_columns()[place_of_row_[row]]] == block_[j])
        block_row_sums_[row] += std::abs(values_[k]);
  return block_row_sums_;
}

/// The signs of each block's pivots times the parity of the row exchanges within it.
void ScaledSystem::orient() {
  std::ranges::fill(counted_, 0);
  for (std::size_t b = 0; b < orientation_.size(); ++b) {
    const auto start = factors_->block_start(), chosen = factors_->pivot_rows();
    const auto pivots = factors_->pivot_values();
    int sign = 1;
    for (int i = start[b]; i < start[b + 1]; ++i) {
      if (pivots[i] < 0) sign = -sign;
      if (counted_[i]) continue;
      for (int j = place_of_row_[chosen[i]]; j != i; j = place_of_row_[chosen[j]]) {
        counted_[j] = 1;
        sign = -sign;
      }
    }
    orientation_[b] = static_cast<signed char>(sign);
  }
}

}  // namespace desmo
