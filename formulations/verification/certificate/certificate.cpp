#include "formulations/verification/certificate/certificate.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "formulations/verification/certificate/certified_groups.h"

namespace desmo {

/// The proof of one instant after the other, group by group.
class Certifier::Proof {
 public:
  Proof(const Model& model, std::span<const Level> levels);
  Certificate certify(const Instant& instant, const LiveRow* drivers);

 private:
  void take(const Instant& instant, const LiveRow* drivers);
  void load(const CertifiedGroup& group);
  bool is_solved(const CertifiedBlock& block, Level level) const;
  bool is_bounded(const CertifiedBlock& block, Level level) const;
  bool bound(CertifiedBlock& block, Level level);
  void leave(const CertifiedGroup& group);

  const Model& m_;
  std::span<const Level> levels_;
  CertifiedGroups structure_;
  std::span<const Level> solved_;  // levels of the present instant
  IntervalState delivered_, state_;
  PerLevel<ErrorRows> rows_;                // of the present group
  PerLevel<std::vector<Interval>> errors_;  // exact minus delivered, of each coordinate
  PerLevel<std::vector<double>> radius_;
};

Certifier::Proof::Proof(const Model& m, std::span<const Level> up_to)
    : m_(m), levels_(up_to), structure_(certified_groups(m)) {
  for (const Level level : levels) {
    for (IntervalState* s : {&delivered_, &state_}) (*s)[level].resize(m.state_size());
    errors_[level].resize(m.coordinates());
    radius_[level].resize(m.coordinates());
    ErrorRows& e = rows_[level];
    e.generators.resize(structure_.max_generators);
    for (auto* values : {&e.center, &e.own, &e.sum, &e.radius}) values->resize(structure_.max_rows);
  }
  for (IntervalState* s : {&delivered_, &state_})
    std::ranges::copy(m.fixed_values, s->position.begin() + m.coordinates());
}

/// Takes the delivered numbers, and the errors of driven ones from the exact motions.
void Certifier::Proof::take(const Instant& instant, const LiveRow* handed_in) {
  const PerLevel<std::span<const double>> values{instant.q, instant.qd, instant.qdd};
  for (const Level level : levels) {
    std::ranges::fill(radius_[level], INFINITY);
    for (std::size_t i = 0; i < values[level].size(); ++i)
      delivered_[level][i] = state_[level][i] = Interval(values[level][i]);
  }
  for (std::size_t k = 0; k < m_.drivers.size(); ++k) {
    const Driver& d = m_.drivers[k];
    const int i = m_.entities[d.coordinate].first;
    PerLevel<Interval> exact;
    if (handed_in) {
      const PerLevel<std::span<const double>> z{handed_in->z, handed_in->zd, handed_in->zdd};
      for (const Level level : solved_) exact[level] = z[level][k];
    } else {
      const MotionSample<Interval> z = sample(d.motion, Interval(instant.time));
      exact = {z.position, z.velocity, z.acceleration};
    }
    for (const Level level : solved_) {
      errors_[level][i] = exact[level] - delivered_[level][i];
      const double radius = errors_[level][i].magnitude();
      state_[level][i].radius = radius_[level][i] = std::isfinite(radius) ? radius : INFINITY;
    }
  }
}

/// Fills the rows of what a group reads, at each of the solved levels.
void Certifier::Proof::load(const CertifiedGroup& group) {
  for (const Level level : solved_) {
    ErrorRows& e = rows_[level];
    e.columns = static_cast<int>(solved_.size()) * group.symbols;
    const auto fill = [&](int row, const Interval& error, int coordinate) {
      e.center[row] = error.mid;
      e.own[row] = error.radius;
      e.sum[row] = error.magnitude();
      e.radius[row] = radius_[level][coordinate];
      std::fill_n(e.of_row(row), e.columns, 0);
    };
    for (const CertifiedGroup::Source& source : group.sources) {
      if (source.interface < 0) {
        fill(source.row, errors_[level][source.coordinate], source.coordinate);
        continue;
      }
      const GroupInterface& from = structure_.interfaces[source.interface];
      const int size = static_cast<int>(from.rows.size());
      for (int i = 0; i < size; ++i) {
        const int row = source.row + i, coordinate = from.coordinates[i];
        if (!from.enclosed) {
          fill(row, errors_[level][coordinate], coordinate);
          continue;
        }
        fill(row, from.center[level][i], coordinate);
        double* generators = e.of_row(row) + solved_.size() * source.symbol;
        for (int s = 0; s < from.basis.size(); ++s) {
          generators[s] = from.basis.generator(static_cast<int>(level) * size + i, s);
          e.sum[row] += std::abs(generators[s]);
        }
        e.sum[row] *= 1 + 4 * from.basis.size() * Interval::unit;
      }
    }
  }
}

/// Encloses what later groups of a chain read of this one.
void Certifier::Proof::leave(const CertifiedGroup& group) {
  const int count = static_cast<int>(solved_.size());
  for (const int index : group.interfaces) {
    GroupInterface& to = structure_.interfaces[index];
    const int size = static_cast<int>(to.rows.size());
    to.enclosed = true;
    for (const Level level : solved_)
      for (const int row : to.rows)
        to.enclosed = to.enclosed && std::isfinite(rows_[level].radius[row]);
    if (!to.enclosed) continue;
    to.basis.start(count * size, count * group.symbols);
    for (const Level level : solved_)
      for (int i = 0; i < size; ++i) {
        const ErrorRows& e = rows_[level];
        const int row = to.rows[i], rank = static_cast<int>(level);
        to.center[level][i] = e.center[row];
        to.basis.set(rank * size + i, e.of_row(row), e.own[row], rank);
      }
    to.basis.enclose();
  }
}

bool Certifier::Proof::is_solved(const CertifiedBlock& block, Level level) const {
  return levels_.empty() || std::ranges::any_of(block.equations().unknowns(),
                                                [&](int i) { return levels_[i] >= level; });
}

/// Returns whether everything that a bound at this level depends on is bounded.
bool Certifier::Proof::is_bounded(const CertifiedBlock& block, Level level) const {
  for (const int row : block.input_rows())
    if (!std::isfinite(rows_[level].radius[row])) return false;
  if (level == Level::position) return true;
  const Level below = level == Level::velocity ? Level::position : Level::velocity;
  return std::isfinite(radius_[below][block.equations().unknowns().front()]);
}

bool Certifier::Proof::bound(CertifiedBlock& block, Level level) {
  const bool proven =
      is_bounded(block, level) &&
      (level == Level::position ? block.prove_positions(state_, rows_)
                                : block.bound_rates(level, delivered_, state_, rows_));
  ErrorRows& e = rows_[level];
  for (int i = 0; i < block.equations().size(); ++i) {
    const int row = block.unknown_rows()[i], coordinate = block.equations().unknowns()[i];
    if (!proven) {  // whoever reads it is not proven either
      e.center[row] = e.own[row] = e.sum[row] = 0;
      e.radius[row] = INFINITY;
      std::fill_n(e.of_row(row), e.columns, 0);
    }
    radius_[level][coordinate] = e.radius[row];
    errors_[level][coordinate] = {e.center[row], e.own[row]};
    for (int k = 0; k < e.columns; ++k)
      errors_[level][coordinate].radius += std::abs(e.of_row(row)[k]);
    errors_[level][coordinate].radius *= 1 + (e.columns + 4) * 2 * Interval::unit;
  }
  return proven;
}

Certificate Certifier::Proof::certify(const Instant& instant, const LiveRow* handed_in) {
  solved_ = std::span(levels).first(instant.qd.empty() ? 1 : instant.qdd.empty() ? 2 : 3);
  take(instant, handed_in);
  Certificate result{.proven = true, .radius = {}};
  for (CertifiedGroup& group : structure_.groups) {
    load(group);
    for (CertifiedBlock& block : group.blocks) {
      block.evaluate(delivered_, solved_.back());
      for (const Level level : solved_) {
        if (bound(block, level) || !is_solved(block, level) || !result.proven) continue;
        result.proven = false;
        result.group = group.id;
        result.coordinate = block.equations().unknowns().front();
      }
    }
    leave(group);
  }
  result.radius = {radius_.position, radius_.velocity, radius_.acceleration};
  return result;
}

Certifier::Certifier(const Model& model, std::span<const Level> levels)
    : proof_(std::make_unique<Proof>(model, levels)) {}
Certifier::~Certifier() = default;

Certificate Certifier::certify(const Instant& instant) { return proof_->certify(instant, nullptr); }
Certificate Certifier::certify(const Instant& instant, const LiveRow& drivers) {
  return proof_->certify(instant, &drivers);
}

}  // namespace desmo
