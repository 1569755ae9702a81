#include "formulations/verification/certificate/certificate.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <vector>

#include "formulations/verification/certificate/block_proof.h"
#include "formulations/verification/certificate/block_schedule.h"

namespace desmo {

/// The proof of one instant after the other, step by step.
class Certifier::Proof {
 public:
  Proof(const Model& model, std::span<const Level> levels);
  Certificate certify(const Instant& instant, const LiveRow* drivers);

 private:
  void take(const Instant& instant, const LiveRow* drivers);
  void load(const ChainLink& link);
  void leave(const ChainLink& link);

  const Model& m_;
  BlockSchedule schedule_;
  BlockProof proof_;
  std::span<const Level> solved_;  // levels of the present instant
  PerLevel<std::vector<double>> delivered_;
  PerLevel<ErrorTable> errors_;
};

namespace {

BlockProof room_for(const BlockSchedule& schedule) {
  int n = 0, m = 0, states = 0;
  for (const CertificationStep& step : schedule.steps)
    for (const BlockBatch& batch : step.batches) {
      const BlockShape& shape = batch.equations.shape();
      n = std::max(n, shape.unknowns);
      m = std::max(m, shape.inputs);
      states = std::max(states, shape.states());
    }
  return {n, m, states, schedule.max_columns};
}

}  // namespace

Certifier::Proof::Proof(const Model& m, std::span<const Level> up_to)
    : m_(m), schedule_(block_schedule(m, up_to)), proof_(room_for(schedule_)) {
  for (const Level level : levels) {
    delivered_[level].resize(m.state_size());
    errors_[level].resize(m.state_size(), schedule_.lent_rows, schedule_.max_generators);
  }
  std::ranges::copy(m.fixed_values, delivered_.position.begin() + m.coordinates());
}

/// Takes the delivered numbers, and the errors of driven ones from the exact motions.
void Certifier::Proof::take(const Instant& instant, const LiveRow* handed_in) {
  using Number = Compensated<double>;
  const PerLevel<std::span<const double>> values{instant.q, instant.qd, instant.qdd};
  for (const Level level : levels) {
    std::fill_n(errors_[level].sum.begin(), m_.coordinates(), INFINITY);
    std::ranges::copy(values[level], delivered_[level].begin());
  }
  for (std::size_t k = 0; k < m_.drivers.size(); ++k) {
    const Driver& d = m_.drivers[k];
    const int i = m_.entities[d.coordinate].first;
    PerLevel<Number> exact;
    if (handed_in) {
      const PerLevel<std::span<const double>> z{handed_in->z, handed_in->zd, handed_in->zdd};
      for (const Level level : solved_) exact[level] = z[level][k];
    } else {
      const MotionSample<Number> z = sample(d.motion, Number(instant.time));
      exact = {z.position, z.velocity, z.acceleration};
    }
    for (const Level level : solved_) {
      const Interval error = (exact[level] - Number(delivered_[level][i])).enclosure();
      const double sum = error.magnitude();
      errors_[level].set(i, error.mid, error.radius, std::isfinite(sum) ? sum : INFINITY);
    }
  }
}

/// Fills the lent rows of what a group reads, at each of the solved levels.
void Certifier::Proof::load(const ChainLink& link) {
  for (const Level level : solved_) {
    ErrorTable& e = errors_[level];
    e.columns = static_cast<int>(solved_.size()) * link.symbols;
    const auto copy = [&](int row, int coordinate) {
      e.set(row, e.center[coordinate], e.own[coordinate], e.sum[coordinate]);
      if (e.has_generators(row)) std::fill_n(e.of_row(row), e.columns, 0);
    };
    for (const ChainLink::Source& source : link.sources) {
      if (source.interface < 0) {
        copy(source.row, source.coordinate);
        continue;
      }
      const GroupInterface& from = schedule_.interfaces[source.interface];
      const int size = static_cast<int>(from.rows.size());
      for (int i = 0; i < size; ++i) {
        const int row = source.row + i;
        copy(row, from.coordinates[i]);
        if (!from.enclosed) continue;
        double sum = std::abs(from.center[level][i]);
        double* generators = e.of_row(row) + solved_.size() * source.symbol;
        for (int s = 0; s < from.basis.size(); ++s) {
          generators[s] = from.basis.generator(static_cast<int>(level) * size + i, s);
          sum += std::abs(generators[s]);
        }
        sum *= 1 + 4 * from.basis.size() * Interval::unit;
        e.set(row, from.center[level][i], 0, sum);
      }
    }
  }
}

/// Encloses what later groups of a chain read of this one.
void Certifier::Proof::leave(const ChainLink& link) {
  const int count = static_cast<int>(solved_.size());
  for (const int index : link.interfaces) {
    GroupInterface& to = schedule_.interfaces[index];
    const int size = static_cast<int>(to.rows.size());
    to.enclosed = true;
    for (const Level level : solved_)
      for (const int row : to.rows)
        to.enclosed = to.enclosed && std::isfinite(errors_[level].sum[row]);
    if (!to.enclosed) continue;
    to.basis.start(count * size, count * link.symbols);
    for (const Level level : solved_)
      for (int i = 0; i < size; ++i) {
        const ErrorTable& e = errors_[level];
        const int row = to.rows[i], rank = static_cast<int>(level);
        to.center[level][i] = e.center[row];
        to.basis.set(rank * size + i, e.of_row(row), e.own[row], rank);
      }
    to.basis.enclose();
  }
  for (const Level level : solved_) errors_[level].columns = 0;
}

Certificate Certifier::Proof::certify(const Instant& instant, const LiveRow* handed_in) {
  solved_ = std::span(levels).first(instant.qd.empty() ? 1 : instant.qdd.empty() ? 2 : 3);
  take(instant, handed_in);
  Certificate result{.proven = true, .radius = {}};
  int first_failure = INT_MAX;
  for (CertificationStep& step : schedule_.steps) {
    if (step.link >= 0) load(schedule_.links[step.link]);
    for (BlockBatch& batch : step.batches) {
      const PerLevel<LaneMask> proven = proof_.prove(batch, delivered_, solved_.back(), errors_);
      for (int lane = 0; lane < batch.blocks(); ++lane) {
        const BlockBatch::Member& member = batch.members[lane];
        for (const Level level : solved_) {
          if (proven[level][lane] || level > member.solved || member.order > first_failure)
            continue;
          first_failure = member.order;
          result.proven = false;
          result.group = member.group;
          result.coordinate = member.first_unknown;
        }
      }
    }
    if (step.link >= 0) leave(schedule_.links[step.link]);
  }
  const std::size_t size = m_.coordinates();
  result.radius = {std::span(errors_.position.sum).first(size),
                   std::span(errors_.velocity.sum).first(size),
                   std::span(errors_.acceleration.sum).first(size)};
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
