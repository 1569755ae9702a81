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
    PerLevel<std::vector<ErrorBasis>> basis;  // one each
    PerLevel<std::vector<double>> center;
  };
  /// Rows and columns of what a group reads: of an interface, or of a driver.
  struct Source {
    int interface, coordinate;  // one of them is -1
    int row, column;            // the first ones
  };
  struct Group {
    GroupId id;
    std::vector<Source> sources;
    std::vector<CertifiedBlock> blocks;
    std::vector<int> interfaces;
    int columns = 0;
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
  void load(const Group& group, Level level);
  bool is_bounded(const CertifiedBlock& block, Level level) const;
  bool bound(CertifiedBlock& block, Level level);
  void give_up(const CertifiedBlock& block, Level level);
  void leave(const Group& group, Level level);

  const Model& m_;
  std::vector<Group> groups_;
  std::vector<Interface> interfaces_;
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
    for (auto* values : {&e.center, &e.sum, &e.radius}) values->resize(origins.rows);
  }
  // A basis is laid out for as many columns as its group has, which is known only now.
  for (Group& g : groups_)
    for (const int i : g.interfaces)
      for (const Level level : levels) {
        Interface& at = interfaces_[i];
        at.basis[level].emplace_back(static_cast<int>(at.rows.size()), g.columns);
        at.center[level].resize(at.rows.size());
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
    if (from >= 0)
      group.sources.push_back({interface(from, coordinates, origins), -1, rows, rows});
    else
      for (int k = 0; k < static_cast<int>(coordinates.size()); ++k)
        group.sources.push_back({-1, coordinates[k], rows + k, rows + k});
    for (const int i : coordinates) row[i] = rows++;
  }
  group.columns = rows;  // as many symbols as inputs, then one for each unknown
  const int unknowns = static_cast<int>(definition.unknowns.size());
  const int columns = rows + unknowns;
  for (const PartDefinition& part : irreducible_blocks(m_, definition)) {
    IntervalBlock equations(m_, part);
    CertifiedBlock::Places places{{}, {}, {}, group.columns, columns};
    std::vector<double> magnitudes;
    for (const int i : equations.inputs()) places.input_rows.push_back(row[i]);
    for (const int i : equations.unknowns()) {
      places.unknown_rows.push_back(row[i] = rows++);
      places.symbols.push_back(group.columns++);
      magnitudes.push_back(origins.magnitudes[i]);
      origins.group[i] = index;
      origins.row[i] = row[i];
    }
    group.blocks.emplace_back(std::move(equations), std::move(places), std::move(magnitudes));
  }
  origins.rows = std::max(origins.rows, rows);
  origins.entries = std::max(origins.entries, rows * group.columns);
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

/// Fills the rows of what a group reads.
void Certifier::Proof::load(const Group& group, Level level) {
  ErrorRows& e = errors_[level];
  e.columns = group.columns;
  const auto fill = [&](int row, double center, int coordinate) {
    e.center[row] = center;
    std::fill_n(e.of_row(row), e.columns, 0);
    e.sum[row] = std::abs(center);
    e.radius[row] = radius_[level][coordinate];
  };
  for (const Source& source : group.sources) {
    if (source.interface < 0) {
      const Interval& error = drivers_[level][source.coordinate];
      fill(source.row, error.mid, source.coordinate);
      e.of_row(source.row)[source.column] = error.radius;
      e.sum[source.row] = error.magnitude();
      continue;
    }
    const Interface& from = interfaces_[source.interface];
    const ErrorBasis& basis = from.basis[level].front();
    for (int i = 0; i < basis.size(); ++i) {
      const int row = source.row + i;
      fill(row, from.center[level][i], from.coordinates[i]);
      for (int s = 0; s < basis.size(); ++s) {
        const double generator = basis.generator(i, s);
        e.of_row(row)[source.column + s] = generator;
        e.sum[row] += std::abs(generator);
      }
      e.sum[row] *= 1 + 4 * basis.size() * Interval::unit;
    }
  }
}

/// Encloses what later groups read of this one.
void Certifier::Proof::leave(const Group& group, Level level) {
  const ErrorRows& e = errors_[level];
  for (const int index : group.interfaces) {
    Interface& to = interfaces_[index];
    ErrorBasis& basis = to.basis[level].front();
    bool all = true;
    for (const int row : to.rows) all = all && std::isfinite(e.radius[row]);
    for (std::size_t i = 0; i < to.rows.size(); ++i)
      to.center[level][i] = all ? e.center[to.rows[i]] : 0;
    if (all)
      basis.enclose({e.generators.data(), e.columns, to.rows});
    else
      basis.enclose_box(e.radius.data(), to.rows);
  }
}

/// Returns whether everything that a bound at this level depends on is bounded.
bool Certifier::Proof::is_bounded(const CertifiedBlock& block, Level level) const {
  for (const int row : block.places().input_rows)
    if (!std::isfinite(errors_[level].radius[row])) return false;
  if (level == Level::position) return true;
  const Level below = level == Level::velocity ? Level::position : Level::velocity;
  return std::isfinite(radius_[below][block.equations().unknowns().front()]);
}

bool Certifier::Proof::bound(CertifiedBlock& block, Level level) {
  if (!is_bounded(block, level)) return false;
  return level == Level::position ? block.prove_positions(delivered_, state_, errors_.position)
                                  : block.bound_rates(level, delivered_, state_, errors_[level]);
}

void Certifier::Proof::give_up(const CertifiedBlock& block, Level level) {
  ErrorRows& e = errors_[level];
  for (const int row : block.places().unknown_rows) {
    e.center[row] = e.sum[row] = 0;
    std::fill_n(e.of_row(row), e.columns, 0);
    e.radius[row] = INFINITY;
  }
  for (const int i : block.equations().unknowns()) state_[level][i].radius = 0;
}

Certificate Certifier::Proof::certify(const Instant& instant, const LiveRow* handed_in) {
  take(instant, handed_in);
  const int count = instant.qd.empty() ? 1 : instant.qdd.empty() ? 2 : 3;
  Certificate result{.proven = true, .radius = {}};
  for (Group& group : groups_) {
    for (const Level level : std::span(levels).first(count)) load(group, level);
    for (CertifiedBlock& block : group.blocks)
      for (const Level level : std::span(levels).first(count)) {
        if (bound(block, level)) {
          for (const int i : block.equations().unknowns())
            radius_[level][i] = state_[level][i].radius;
          continue;
        }
        give_up(block, level);
        if (result.proven)
          result.group = group.id, result.coordinate = block.equations().unknowns()[0];
        result.proven = false;
      }
    for (const Level level : std::span(levels).first(count)) leave(group, level);
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
