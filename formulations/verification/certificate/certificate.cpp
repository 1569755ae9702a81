#include "formulations/verification/certificate/certificate.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <vector>

#include "formulations/verification/certificate/block_proof.h"
#include "formulations/verification/certificate/block_schedule.h"
#include "formulations/verification/certificate/certified_instant.h"

namespace desmo {

/// Schedule, errors and workspace of a certifier.
class Certifier::Proof {
 public:
  Proof(const Model& model, std::span<const Level> levels);
  Certificate certify(const Instant& instant, const LiveRow* drivers, ErrorSets sets);
  const std::shared_ptr<BlockSchedule>& schedule() const { return schedule_; }

 private:
  Certificate certify_in(const Instant& instant, const LiveRow* drivers, ErrorSets sets);
  void take(const Instant& instant, const LiveRow* drivers);
  void load(const ChainLink& link);
  void leave(const ChainLink& link);

  const Model& m_;
  std::shared_ptr<BlockSchedule> schedule_;
  BlockProof proof_;
  std::span<const Level> solved_;  // levels of the present instant
  ErrorSets sets_ = ErrorSets::boxes;
  PerLevel<ErrorTable> errors_;
  std::vector<double> unbounded_, zeros_;  // results at levels that are not solved
};

Certifier::Proof::Proof(const Model& m, std::span<const Level> up_to)
    : m_(m),
      schedule_(std::make_shared<BlockSchedule>(block_schedule(m, up_to))),
      proof_(schedule_->largest),
      unbounded_(m.coordinates(), INFINITY),
      zeros_(m.coordinates()) {
  for (const Level level : all_levels) {
    ErrorTable& e = errors_[level];
    e.rows.resize(m.state_size() + schedule_->lent_rows);
    for (std::vector<double>* values : {&e.radius, &e.correction, &e.rest})
      values->resize(m.coordinates());
    e.generators.resize(schedule_->max_generators);
    e.first_lent = m.state_size();
  }
  for (std::size_t i = 0; i < m.fixed_values.size(); ++i)
    errors_.position.rows[m.coordinates() + i].delivered = m.fixed_values[i];
}

/// Takes the delivered numbers. Finds the errors of driven coordinates from the exact motions, or
/// from drivers that were handed in. The errors of all other coordinates are unknown: infinite.
void Certifier::Proof::take(const Instant& instant, const LiveRow* handed_in) {
  using Number = Compensated<double>;
  const PerLevel<std::span<const double>> values{instant.q, instant.qd, instant.qdd};
  for (const Level level : all_levels) {
    ErrorTable::Row* row = errors_[level].rows.data();
    for (const double x : values[level]) *row++ = {x, 0, 0, INFINITY};
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
      ErrorTable::Row& row = errors_[level].rows[i];
      const Interval error = (exact[level] - Number(row.delivered)).enclosure();
      if (std::isfinite(error.magnitude()))
        row = {row.delivered, error.mid, error.radius, error.magnitude()};
    }
  }
}

/// Fills the lent rows that a link of chains reads, at each of the solved levels.
void Certifier::Proof::load(const ChainLink& link) {
  const int count = sets_ == ErrorSets::bases ? static_cast<int>(solved_.size()) : 0;
  for (const Level level : solved_) {
    errors_[level].columns = count * link.symbols;
    for (const ChainLink::Source& source : link.sources)
      schedule_->interfaces[source.interface].lend(level, source.row, count * source.symbol,
                                                   errors_[level]);
  }
}

/// Encloses the errors of a group's interfaces, which later groups of the chain read.
void Certifier::Proof::leave(const ChainLink& link) {
  const std::span<const Level> enclosed =
      solved_.first(sets_ == ErrorSets::bases ? solved_.size() : 0);
  for (const int index : link.interfaces) schedule_->interfaces[index].enclose(enclosed, errors_);
  for (const Level level : solved_) errors_[level].columns = 0;
}

Certificate Certifier::Proof::certify(const Instant& instant, const LiveRow* handed_in,
                                      ErrorSets sets) {
  const Certificate found = certify_in(instant, handed_in, sets);
  return found.proven || sets == ErrorSets::bases || schedule_->links.empty()
             ? found
             : certify_in(instant, handed_in, ErrorSets::bases);
}

Certificate Certifier::Proof::certify_in(const Instant& instant, const LiveRow* handed_in,
                                         ErrorSets sets) {
  sets_ = sets;
  solved_ = levels_of({instant.q, instant.qd, instant.qdd});
  take(instant, handed_in);
  Certificate result{.proven = true};
  int first_failure = INT_MAX;
  for (CertificationStep& step : schedule_->steps) {
    if (step.link >= 0) load(schedule_->links[step.link]);
    for (BlockBatch& batch : step.batches) {
      const PerLevel<LaneMask> proven = proof_.prove(batch, solved_.back(), errors_, instant.time);
      for (int lane = 0; lane < batch.size(); ++lane) {
        const BlockBatch::PlacedBlock& block = batch.blocks[lane];
        if (const double condition = proof_.condition()[lane]; condition > result.condition) {
          result.condition = condition;
          result.worst_conditioned = block.group;
        }
        // Where a level is proven, all lower ones are.
        const Level last = std::min(block.solved, solved_.back());
        if (proven[last][lane] || block.order > first_failure) continue;
        first_failure = block.order;
        result.proven = false;
        result.group = block.group;
        result.failure = proof_.failure(lane);
        if (result.failure != ProofFailure::singular) continue;
        result.condition = INFINITY;
        result.worst_conditioned = block.group;
      }
    }
    if (step.link >= 0) leave(schedule_->links[step.link]);
  }
  for (const Level level : all_levels) {
    ErrorTable& e = errors_[level];
    const bool is_solved = level <= solved_.back();
    if (is_solved) e.write_bounds();
    result.radius[level] = is_solved ? e.radius : unbounded_;
    result.correction[level] = is_solved ? e.correction : zeros_;
    result.rest[level] = is_solved ? e.rest : unbounded_;
  }
  return result;
}

Certifier::Certifier(const Model& model, std::span<const Level> levels)
    : proof_(std::make_unique<Proof>(model, levels)) {}
Certifier::~Certifier() = default;

Certificate Certifier::certify(const Instant& instant, ErrorSets sets) {
  return proof_->certify(instant, nullptr, sets);
}
Certificate Certifier::certify(const Instant& instant, const LiveRow& drivers) {
  return proof_->certify(instant, &drivers, ErrorSets::boxes);
}

bool Certifier::has_long_chains() const { return !schedule()->links.empty(); }
const std::shared_ptr<BlockSchedule>& Certifier::schedule() const { return proof_->schedule(); }

}  // namespace desmo
