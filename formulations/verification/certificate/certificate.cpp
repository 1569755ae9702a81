#include "formulations/verification/certificate/certificate.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "formulations/scaling/characteristic_lengths.h"
#include "formulations/verification/certificate/certified_block.h"
#include "formulations/verification/certificate/error_basis.h"

namespace desmo {

/// The blocks of a model by structural group, and the errors between groups.
class Certifier::Proof {
 public:
  explicit Proof(const Model& model);
  Certificate certify(const Instant& instant, const LiveRow* drivers);

 private:
  /// What a later group reads of an earlier one: some of its rows in ErrorRows.
  struct Interface {
    std::vector<int> coordinates, rows;
    bool enclosed = false;          // by the basis; otherwise the radii alone are known
    std::vector<ErrorBasis> basis;  // one, of all coordinates at one level after the other
    PerLevel<std::vector<double>> center;
  };
  /// Rows and columns of what a group reads: of an interface, or of a driver.
  struct Source {
    int interface, coordinate;  // one of them is -1
    int row;                    // the first one
    int symbol;                 // the first one at one level
  };
  struct Group {
    GroupId id;
    std::vector<Source> sources;
    std::vector<CertifiedBlock> blocks;
    std::vector<int> interfaces;
    int symbols = 0;  // for each level
  };
  /// Finds where errors come from while groups are added.
  struct Origins {
    std::vector<int> group, row;  // of each coordinate; -1: driven
    std::map<std::pair<int, std::vector<int>>, int> interfaces;
    std::vector<double> magnitudes;
    int rows = 0, entries = 0;  // largest of any group
  };

  void add_group(const PartDefinition& group, Origins& origins);
  int interface(int group, const std::vector<int>& coordinates, Origins& origins);
  void take(const Instant& instant, const LiveRow* drivers);
  void load(const Group& group);
  bool is_bounded(const CertifiedBlock& block, Level level) const;
  bool bound(CertifiedBlock& block, Level level);
  void leave(const Group& group);

  const Model& m_;
  std::vector<Group> groups_;
  std::vector<Interface> interfaces_;
  std::span<const Level> solved_;  // levels of the present instant
  IntervalState delivered_, state_;
  PerLevel<ErrorRows> errors_;  // of the present group
  PerLevel<std::vector<double>> radius_;
  PerLevel<std::vector<Interval>> drivers_;  // exact minus delivered, by coordinate
};

Certifier::Proof::Proof(const Model& m) : m_(m) {
  const std::size_t size = m.state_size();
  for (const Level level : levels) {
    delivered_[level].resize(size);
    state_[level].resize(size);
    radius_[level].resize(m.coordinates());
    drivers_[level].resize(m.coordinates());
  }
  for (IntervalState* s : {&delivered_, &state_})
    std::ranges::copy(m.fixed_values, s->position.begin() + m.coordinates());
  Origins origins{std::vector<int>(size, -1),
                  std::vector<int>(size, -1),
                  {},
                  CharacteristicLengths(m).of_coordinates()};
  for (const PartDefinition& group : make_partition(m, Partition::group)) add_group(group, origins);
  for (const Level level : levels) {
    ErrorRows& e = errors_[level];
    e.generators.resize(origins.entries);
    for (auto* values : {&e.center, &e.own, &e.sum, &e.radius}) values->resize(origins.rows);
  }
  for (const Group& g : groups_)
    for (const int i : g.interfaces) {
      const int errors = static_cast<int>(levels.size() * interfaces_[i].rows.size());
      interfaces_[i].basis.emplace_back(errors, static_cast<int>(levels.size()) * g.symbols);
      for (const Level level : levels) interfaces_[i].center[level].resize(errors);
    }
}

int Certifier::Proof::interface(int group, const std::vector<int>& coordinates, Origins& origins) {
  const auto [it, is_new] =
      origins.interfaces.try_emplace({group, coordinates}, interfaces_.size());
  if (is_new) {
    Interface& made = interfaces_.emplace_back();
    made.coordinates = coordinates;
    for (const int i : coordinates) made.rows.push_back(origins.row[i]);
    groups_[group].interfaces.push_back(it->second);
  }
  return it->second;
}

void Certifier::Proof::add_group(const PartDefinition& definition, Origins& origins) {
  const int index = static_cast<int>(groups_.size());
  Group group{definition.groups.front(), {}, {}, {}};
  std::map<int, std::vector<int>> read;  // coordinates by group; -1: driven
  const IntervalBlock whole(m_, definition);
  for (const int i : whole.inputs()) read[origins.group[i]].push_back(i);
  std::vector<int> row(m_.coordinates(), -1);
  int rows = 0;
  for (const auto& [from, coordinates] : read) {
    const int size = static_cast<int>(coordinates.size());
    if (from >= 0) {
      group.sources.push_back({interface(from, coordinates, origins), -1, rows, group.symbols});
      group.symbols += size;
    } else {
      for (int k = 0; k < size; ++k) group.sources.push_back({-1, coordinates[k], rows + k, 0});
    }
    for (const int i : coordinates) row[i] = rows++;
  }
  const int columns = static_cast<int>(levels.size()) * group.symbols;
  for (const PartDefinition& part : irreducible_blocks(m_, definition)) {
    IntervalBlock equations(m_, part);
    std::vector<int> block_rows;
    std::vector<double> magnitudes;
    for (const int i : equations.unknowns()) {
      block_rows.push_back(row[i] = rows++);
      magnitudes.push_back(origins.magnitudes[i]);
      origins.group[i] = index;
      origins.row[i] = row[i];
    }
    for (const int i : equations.inputs()) block_rows.push_back(row[i]);
    group.blocks.emplace_back(std::move(equations), std::move(block_rows), columns,
                              std::move(magnitudes));
  }
  origins.rows = std::max(origins.rows, rows);
  origins.entries = std::max(origins.entries, rows * columns);
  groups_.push_back(std::move(group));
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
      for (const Level level : levels)
        if (!values[level].empty()) exact[level] = z[level][k];
    } else {
      const MotionSample<Interval> z = sample(d.motion, Interval(instant.time));
      exact = {z.position, z.velocity, z.acceleration};
    }
    for (const Level level : levels) {
      if (values[level].empty()) continue;
      drivers_[level][i] = exact[level] - delivered_[level][i];
      const double radius = drivers_[level][i].magnitude();
      state_[level][i].radius = radius_[level][i] = std::isfinite(radius) ? radius : INFINITY;
    }
  }
}

/// Fills the rows of what a group reads, at each of the solved levels.
void Certifier::Proof::load(const Group& group) {
  for (const Level level : solved_) {
    ErrorRows& e = errors_[level];
    e.columns = static_cast<int>(solved_.size()) * group.symbols;
    const auto fill = [&](int row, double center, double own, int coordinate) {
      e.center[row] = center;
      e.own[row] = own;
      e.sum[row] = (std::abs(center) + own) * (1 + 4 * Interval::unit);
      e.radius[row] = radius_[level][coordinate];
      std::fill_n(e.of_row(row), e.columns, 0);
    };
    for (const Source& source : group.sources) {
      if (source.interface < 0) {
        const Interval& error = drivers_[level][source.coordinate];
        fill(source.row, error.mid, error.radius, source.coordinate);
        continue;
      }
      const Interface& from = interfaces_[source.interface];
      const int size = static_cast<int>(from.rows.size());
      for (int i = 0; i < size; ++i) {
        const int row = source.row + i, coordinate = from.coordinates[i];
        if (!from.enclosed) {
          fill(row, 0, radius_[level][coordinate], coordinate);
          continue;
        }
        fill(row, from.center[level][i], 0, coordinate);
        const ErrorBasis& basis = from.basis.front();
        double* generators = e.of_row(row) + solved_.size() * source.symbol;
        for (int s = 0; s < basis.size(); ++s) {
          generators[s] = basis.generator(static_cast<int>(level) * size + i, s);
          e.sum[row] += std::abs(generators[s]);
        }
        e.sum[row] *= 1 + 4 * basis.size() * Interval::unit;
      }
    }
  }
}

/// Encloses what later groups read of this one.
void Certifier::Proof::leave(const Group& group) {
  for (const int index : group.interfaces) {
    Interface& to = interfaces_[index];
    const int size = static_cast<int>(to.rows.size());
    to.enclosed = true;
    for (const Level level : solved_)
      for (const int row : to.rows)
        to.enclosed = to.enclosed && std::isfinite(errors_[level].radius[row]);
    if (!to.enclosed) continue;
    ErrorBasis& basis = to.basis.front();
    basis.start(static_cast<int>(solved_.size()) * size,
                static_cast<int>(solved_.size()) * group.symbols);
    for (const Level level : solved_)
      for (int i = 0; i < size; ++i) {
        const ErrorRows& e = errors_[level];
        to.center[level][i] = e.center[to.rows[i]];
        basis.set(static_cast<int>(level) * size + i, e.of_row(to.rows[i]), e.own[to.rows[i]],
                  static_cast<int>(level));
      }
    basis.enclose();
  }
}

/// Returns whether everything that a bound at this level depends on is bounded.
bool Certifier::Proof::is_bounded(const CertifiedBlock& block, Level level) const {
  for (const int row : block.input_rows())
    if (!std::isfinite(errors_[level].radius[row])) return false;
  if (level == Level::position) return true;
  const Level below = level == Level::velocity ? Level::position : Level::velocity;
  return std::isfinite(radius_[below][block.equations().unknowns().front()]);
}

bool Certifier::Proof::bound(CertifiedBlock& block, Level level) {
  const bool proven =
      is_bounded(block, level) &&
      (level == Level::position ? block.prove_positions(state_, errors_)
                                : block.bound_rates(level, delivered_, state_, errors_));
  const std::vector<int>& unknowns = block.equations().unknowns();
  ErrorRows& e = errors_[level];
  for (int i = 0; i < block.equations().size(); ++i) {
    if (!proven) {  // whoever reads it is not proven either
      const int row = block.unknown_rows()[i];
      e.center[row] = e.own[row] = e.sum[row] = 0;
      e.radius[row] = INFINITY;
      std::fill_n(e.of_row(row), e.columns, 0);
    } else {
      radius_[level][unknowns[i]] = state_[level][unknowns[i]].radius;
    }
  }
  return proven;
}

Certificate Certifier::Proof::certify(const Instant& instant, const LiveRow* handed_in) {
  solved_ = std::span(levels).first(instant.qd.empty() ? 1 : instant.qdd.empty() ? 2 : 3);
  take(instant, handed_in);
  Certificate result{.proven = true, .radius = {}};
  for (Group& group : groups_) {
    load(group);
    for (CertifiedBlock& block : group.blocks) {
      block.evaluate(delivered_, solved_.back());
      for (const Level level : solved_) {
        if (bound(block, level) || !result.proven) continue;
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

Certifier::Certifier(const Model& model) : proof_(std::make_unique<Proof>(model)) {}
Certifier::~Certifier() = default;

Certificate Certifier::certify(const Instant& instant) { return proof_->certify(instant, nullptr); }
Certificate Certifier::certify(const Instant& instant, const LiveRow& drivers) {
  return proof_->certify(instant, &drivers);
}

}  // namespace desmo
