#include "formulations/algebra/condensation.h"

#include <algorithm>
#include <map>

namespace desmo {

Condensed::Condensed(const Pattern& pattern, std::span<const Derivation> derivations,
                     const MakeSolver& make_solver)
    : scale_(derivations.size()), x_(pattern.n - derivations.size()), y_(derivations.size()) {
  std::vector<std::vector<Term>> rows(pattern.n);  // entries of each row of A
  for (int j = 0; j < pattern.n; ++j)
    for (int k = pattern.column_start[j]; k < pattern.column_start[j + 1]; ++k)
      rows[pattern.row[k]].push_back({j, k});

  std::vector<bool> is_derived(pattern.n), is_derivation(pattern.n);  // columns, rows of A
  for (const auto& [row, column] : derivations) {
    is_derivation[row] = is_derived[column] = true;
    DerivedUnknown derived{row, column, 0, static_cast<int>(terms_.size()), 0};
    for (const Term& entry : rows[row])
      if (entry.column == column)
        derived.pivot = entry.from;
      else
        terms_.push_back(entry);
    derived.end = static_cast<int>(terms_.size());
    derived_.push_back(derived);
  }
  for (int i = 0; i < pattern.n; ++i) {
    if (!is_derivation[i]) closure_row_.push_back(i);
    if (!is_derived[i]) column_.push_back(i);
  }

  // The closures with a value in each column of A, each with the position of the value in work_.
  // Derivations add some, the last derivation first: then its own column has all of its closures.
  const int closures = static_cast<int>(closure_row_.size());
  const int last = static_cast<int>(derived_.size()) - 1;
  std::vector<std::map<int, int>> place(pattern.n);
  for (int c = 0; c < closures; ++c)
    for (const Term& entry : rows[closure_row_[c]]) place[entry.column][c] = 0;
  for (int d = last; d >= 0; --d)
    for (const auto& [c, position] : place[derived_[d].column])
      for (int t = derived_[d].first; t < derived_[d].end; ++t) place[terms_[t].column][c] = 0;

  // Positions: A_r compressed by columns, then C_y.
  reduced_.n = static_cast<int>(column_.size());
  reduced_.column_start.push_back(0);
  for (const int j : column_) {
    reduced_.unknowns.push_back(pattern.unknowns[j]);
    for (auto& [c, position] : place[j]) {
      position = cleared_++;
      reduced_.row.push_back(c);
    }
    reduced_.column_start.push_back(cleared_);
  }
  for (const DerivedUnknown& d : derived_)
    for (auto& [c, position] : place[d.column]) position = cleared_++;

  for (int c = 0; c < closures; ++c)
    for (const Term& entry : rows[closure_row_[c]])
      copies_.push_back({place[entry.column].at(c), entry.from});
  // Derivation by derivation, the last first: neighbours are of different closures, so that the
  // processor need not wait for what it has just written.
  for (int d = last; d >= 0; --d)
    for (const auto& [c, factor] : place[derived_[d].column]) {
      derived_terms_.push_back({c, d, factor});
      for (int t = derived_[d].first; t < derived_[d].end; ++t)
        operations_.push_back({place[terms_[t].column].at(c), factor, cleared_ + t});
    }
  work_.resize(cleared_ + terms_.size());
  if (reduced_.n > 0) solver_ = make_solver(reduced_);
}

bool Condensed::factor(const double* values) {
  std::fill_n(work_.begin(), cleared_, 0.0);
  for (const Copy& copy : copies_) work_[copy.to] = values[copy.from];
  double* const terms = work_.data() + cleared_;
  for (std::size_t d = 0; d < derived_.size(); ++d) {
    scale_[d] = -1 / values[derived_[d].pivot];
    for (int t = derived_[d].first; t < derived_[d].end; ++t)
      terms[t] = scale_[d] * values[terms_[t].from];
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
      y += work_[cleared_ + t] * b[terms_[t].column];
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
