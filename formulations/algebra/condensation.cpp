#include "formulations/algebra/condensation.h"

#include <algorithm>
#include <iterator>
#include <map>

namespace desmo {

Condensed::Condensed(const Pattern& pattern, std::span<const Derivation> derivations,
                     const MakeSolver& make_solver) {
  struct Entry {
    int column, value;  // column of A, position of its value
  };
  std::vector<std::vector<Entry>> rows(pattern.n);  // entries of each row of A
  for (int j = 0; j < pattern.n; ++j)
    for (int k = pattern.column_start[j]; k < pattern.column_start[j + 1]; ++k)
      rows[pattern.row[k]].push_back({j, k});

  // whether each column of A is derived, whether each row is a derivation
  std::vector<bool> is_derived(pattern.n), is_derivation(pattern.n);
  for (const Derivation& d : derivations) {
    is_derived[d.column] = true;
    is_derivation[d.row] = true;
    DerivedUnknown derived{d.row, d.column, 0, static_cast<int>(terms_.size()), 0};
    for (const auto& [column, value] : rows[d.row])
      if (column == d.column)
        derived.pivot = value;
      else
        terms_.push_back({column, value, 0});
    derived.end = static_cast<int>(terms_.size());
    derived_.push_back(derived);
  }
  std::vector<int> reduced_column(pattern.n, -1);
  for (int j = 0; j < pattern.n; ++j) {
    if (is_derived[j]) continue;
    reduced_column[j] = static_cast<int>(column_.size());
    column_.push_back(j);
    reduced_.unknowns.push_back(pattern.unknowns[j]);
  }
  for (int i = 0; i < pattern.n; ++i)
    if (!is_derivation[i]) closure_row_.push_back(i);
  reduced_.n = static_cast<int>(column_.size());

  // Numbers the values of each closure, those of A and those that derivations add, in the order in
  // which they occur. Copies and operations use these numbers until positions are known.
  std::vector<std::map<int, int>> places(closure_row_.size());
  std::vector<std::vector<DerivedTerm>> factors(derived_.size());
  std::vector<std::vector<Operation>> operations(derived_.size());
  int count = 0;
  for (std::size_t c = 0; c < closure_row_.size(); ++c) {
    std::map<int, int>& place = places[c];
    for (const auto& [column, value] : rows[closure_row_[c]]) {
      copies_.push_back({count, value});
      place[column] = count++;
    }
    for (int d = static_cast<int>(derived_.size()) - 1; d >= 0; --d) {
      const auto at = place.find(derived_[d].column);
      if (at == place.end()) continue;
      const int factor = at->second;
      factors[d].push_back({static_cast<int>(c), d, factor});
      for (int t = derived_[d].first; t < derived_[d].end; ++t) {
        const auto [target, is_new] = place.emplace(terms_[t].column, count);
        count += is_new;
        operations[d].push_back({target->second, factor, t});
      }
    }
  }

  // Derivation by derivation, the last first: neighbours are of different closures, so that the
  // processor need not wait for what it has just written.
  for (int d = static_cast<int>(derived_.size()) - 1; d >= 0; --d) {
    std::ranges::copy(factors[d], std::back_inserter(derived_terms_));
    std::ranges::copy(operations[d], std::back_inserter(operations_));
  }

  // Positions in the values: A_r compressed by columns, then C_y, then the terms of derivations.
  std::vector<int> position(count, -1);
  reduced_.column_start.push_back(0);
  for (const int j : column_) {
    for (std::size_t c = 0; c < places.size(); ++c)
      if (const auto at = places[c].find(j); at != places[c].end()) {
        position[at->second] = static_cast<int>(reduced_.row.size());
        reduced_.row.push_back(static_cast<int>(c));
      }
    reduced_.column_start.push_back(static_cast<int>(reduced_.row.size()));
  }
  cleared_ = static_cast<int>(reduced_.row.size());
  for (int& p : position)
    if (p < 0) p = cleared_++;
  for (std::size_t t = 0; t < terms_.size(); ++t) terms_[t].to = cleared_ + static_cast<int>(t);
  for (Copy& copy : copies_) copy.to = position[copy.to];
  for (DerivedTerm& term : derived_terms_) term.factor = position[term.factor];
  for (Operation& o : operations_)
    o = {position[o.target], position[o.factor], terms_[o.source].to};

  work_.resize(cleared_ + terms_.size());
  scale_.resize(derived_.size());
  x_.resize(column_.size());
  y_.resize(derived_.size());
  if (reduced_.n > 0) solver_ = make_solver(reduced_);
}

bool Condensed::factor(const double* values) {
  std::fill_n(work_.begin(), cleared_, 0.0);
  for (const Copy& copy : copies_) work_[copy.to] = values[copy.from];
  for (std::size_t d = 0; d < derived_.size(); ++d) {
    scale_[d] = -1 / values[derived_[d].pivot];
    for (int t = derived_[d].first; t < derived_[d].end; ++t)
      work_[terms_[t].to] = scale_[d] * values[terms_[t].from];
  }
  for (const Operation& o : operations_) work_[o.target] += work_[o.factor] * work_[o.source];
  return !solver_ || solver_->factor(work_.data());
}

void Condensed::solve(double* b) {
  for (std::size_t d = 0; d < derived_.size(); ++d) y_[d] = -scale_[d] * b[derived_[d].row];
  for (std::size_t c = 0; c < closure_row_.size(); ++c) x_[c] = b[closure_row_[c]];
  for (const DerivedTerm& t : derived_terms_) x_[t.closure] -= work_[t.factor] * y_[t.derived];
  if (solver_) solver_->solve(x_.data());
  for (std::size_t j = 0; j < column_.size(); ++j) b[column_[j]] = x_[j];
  for (std::size_t d = 0; d < derived_.size(); ++d) {
    double y = y_[d];
    for (int t = derived_[d].first; t < derived_[d].end; ++t)
      y += work_[terms_[t].to] * b[terms_[t].column];
    b[derived_[d].column] = y;
  }
}

void Condensed::solve_closures(double* b) {
  for (std::size_t c = 0; c < closure_row_.size(); ++c) x_[c] = b[closure_row_[c]];
  if (solver_) solver_->solve(x_.data());
  for (const DerivedUnknown& d : derived_) b[d.column] = 0;
  for (std::size_t j = 0; j < column_.size(); ++j) b[column_[j]] = x_[j];
}

int Condensed::break_even_solves() const {
  return solver_ ? solver_->break_even_solves() : LinearSolver::break_even_solves();
}

Pivots Condensed::pivots() const { return solver_ ? solver_->pivots() : Pivots{}; }

void Condensed::forget_pivots() {
  if (solver_) solver_->forget_pivots();
}

}  // namespace desmo
