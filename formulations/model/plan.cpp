#include "formulations/model/plan.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "formulations/base/index_range.h"
#include "formulations/model/members.h"
#include "formulations/model/part_system.h"
#include "formulations/model/partition.h"

namespace desmo {

namespace {

/// The blocks, entities and constraints that outputs depend on, and up to which level.
class Upstream {
 public:
  explicit Upstream(const Model& m)
      : blocks(make_partition(m, Partition::block)),
        block_level(blocks.size()),
        entity_level(m.entities.size()),
        constraint_kept(m.constraints.size(), false),
        serves(m.entities.size(), -1),
        m_(m),
        has_unknowns_(m.groups.size(), false),
        group_needed_(m.groups.size(), false),
        owner_(entity_of_coordinate(m)),
        block_of_coordinate_(m.coordinates(), -1),
        blocks_of_constraint_(m.constraints.size()) {
    for (int b = 0; b < static_cast<int>(blocks.size()); ++b) {
      has_unknowns_[blocks[b].groups.front()] = true;
      for (const int i : blocks[b].unknowns) block_of_coordinate_[i] = b;
      for (const Equation& e : blocks[b].equations)
        blocks_of_constraint_[e.constraint].push_back(b);
    }
  }

  void need_output(const Output& output) {
    need(output.entity, output.level, output.entity);
    while (!waiting_.empty()) {
      const auto [b, level] = waiting_.back();
      waiting_.pop_back();
      if (block_level[b] && *block_level[b] >= level) continue;
      block_level[b] = level;
      group_needed_[blocks[b].groups.front()] = true;
      for (const int i : blocks[b].unknowns) need(owner_[i], level, output.entity);
      for (const Equation& e : blocks[b].equations) {
        constraint_kept[e.constraint] = true;
        for (const int other : blocks_of_constraint_[e.constraint])
          waiting_.emplace_back(other, level);
        for (const EntityId operand : m_.constraints[e.constraint].operands)
          need(operand, level, output.entity);
      }
    }
  }

  void need_mechanism() {
    for (EntityId e = 0; e < static_cast<EntityId>(m_.entities.size()); ++e)
      need_output({e, Level::position});
  }

  /// Marks as needed what left-out equations of needed groups read. It goes from the last group to
  /// the first, since a group needs earlier ones only.
  void need_left_out_equations() {
    for (auto c = m_.constraints.rbegin(); c != m_.constraints.rend(); ++c)
      if (c->left_out && group_needed_[c->group])
        for (const EntityId operand : c->operands) need_output({operand, Level::position});
  }

  /// Keeps constraints that can be checked: all of their rows are left out, and all operands are
  /// known. A constraint between constants is kept with its group, and always in a group without
  /// unknowns.
  void keep_consequences() {
    for (std::size_t c = 0; c < m_.constraints.size(); ++c) {
      const Constraint& constraint = m_.constraints[c];
      if (kept_rows(constraint) > 0) continue;
      const GroupId g = constraint.group;
      const auto is_known = [&](EntityId id) { return m_.entities[id].fixed || entity_level[id]; };
      constraint_kept[c] = is_constant(m_, constraint)
                               ? group_needed_[g] || !has_unknowns_[g]
                               : std::ranges::all_of(constraint.operands, is_known);
      if (!constraint_kept[c]) continue;
      for (const EntityId id : constraint.operands)
        if (m_.entities[id].fixed) need(id, Level::position, constraint.operands.front());
    }
  }

  std::vector<PartDefinition> blocks;
  // highest level needed of each block; none: it is not needed
  std::vector<std::optional<Level>> block_level;
  std::vector<std::optional<Level>> entity_level;
  std::vector<bool> constraint_kept;
  std::vector<EntityId> serves;  // entity for which each one was first needed; -1: it is not

 private:
  void need(EntityId id, Level level, EntityId for_whom) {
    if (entity_level[id] && *entity_level[id] >= level) return;
    entity_level[id] = level;
    if (serves[id] < 0) serves[id] = for_whom;
    const Entity& e = m_.entities[id];
    for (int i = e.first; !e.fixed && i < e.first + e.size; ++i)
      if (block_of_coordinate_[i] >= 0) waiting_.emplace_back(block_of_coordinate_[i], level);
  }

  const Model& m_;
  std::vector<bool> has_unknowns_, group_needed_;  // for each group
  std::vector<EntityId> owner_;
  std::vector<int> block_of_coordinate_;  // block that solves each coordinate; -1: it is driven
  std::vector<std::vector<int>> blocks_of_constraint_;
  std::vector<std::pair<int, Level>> waiting_;
};

/// Returns the entities, constraints and drivers that are needed of a model.
Members needed_members(const Model& whole, const Upstream& up) {
  Members needed;
  for (std::size_t e = 0; e < whole.entities.size(); ++e)
    if (up.entity_level[e]) needed.entities.push_back(static_cast<EntityId>(e));
  for (std::size_t c = 0; c < whole.constraints.size(); ++c)
    if (up.constraint_kept[c]) needed.constraints.push_back(static_cast<int>(c));
  for (std::size_t d = 0; d < whole.drivers.size(); ++d)
    if (up.entity_level[whole.drivers[d].coordinate]) needed.drivers.push_back(static_cast<int>(d));
  return needed;
}

/// Returns whether the Jacobian of a block by its unknowns is the same at the estimate and at
/// another position.
bool is_linear(const Model& m, const PartDefinition& block, ScalarState<double>& drawn) {
  const std::vector<double> before = PartSystem<double>(m, block, drawn).jacobian;
  for (std::size_t k = 0; k < block.unknowns.size(); ++k) drawn.q[block.unknowns[k]] += k + 1;
  const std::vector<double> after = PartSystem<double>(m, block, drawn).jacobian;
  for (const int i : block.unknowns) drawn.q[i] = m.estimate[i];
  return after == before;
}

/// Returns whether a block may have no solution: a point or vector is among its unknowns, and an
/// equation is not linear. In a group of one body, such as a crank, an equation counts as linear
/// where it is linear in the block's unknowns.
/// - owner: entity of each coordinate
/// - drawn: estimate and fixed values; changed, then restored
bool may_lock(const Model& m, const PartDefinition& block, const std::vector<EntityId>& owner,
              ScalarState<double>& drawn) {
  const auto is_geometric = [&](int coordinate) {
    const EntityKind kind = m.entities[owner[coordinate]].kind;
    return kind == EntityKind::point || kind == EntityKind::vector;
  };
  if (std::ranges::none_of(block.unknowns, is_geometric)) return false;
  if (m.groups[block.groups.front()].bodies.size() == 1) return !is_linear(m, block, drawn);
  return !std::ranges::all_of(
      block.equations, [&](const Equation& e) { return is_linear(m.constraints[e.constraint]); });
}

std::vector<Plan::GroupUse> describe_use(const Model& whole, const Upstream& up,
                                         std::span<const Output> outputs) {
  std::vector<Plan::GroupUse> uses(whole.groups.size());
  for (std::size_t g = 0; g < uses.size(); ++g) uses[g].name = whole.groups[g].name;
  std::vector<bool> is_output(whole.entities.size(), false);
  for (const Output& output : outputs) is_output[output.entity] = true;
  const std::vector<EntityId> owner = entity_of_coordinate(whole);
  ScalarState<double> drawn(whole.state_size());
  drawn.q = whole.state_of(whole.estimate);
  for (std::size_t b = 0; b < up.blocks.size(); ++b) {
    Plan::GroupUse& use = uses[up.blocks[b].groups.front()];
    const int n = static_cast<int>(up.blocks[b].unknowns.size());
    use.unknowns += n;
    ++use.blocks;
    if (!up.block_level[b]) {
      use.may_lock |= may_lock(whole, up.blocks[b], owner, drawn);
      continue;
    }
    use.kept_unknowns += n;
    ++use.kept_blocks;
    use.level = std::max(use.level, *up.block_level[b]);
  }
  for (std::size_t i = 0; i < whole.constraints.size(); ++i)
    if (const Constraint& c = whole.constraints[i]; is_constant(whole, c) && !up.constraint_kept[i])
      uses[c.group].may_lock = true;
  for (std::size_t i = 0; i < whole.entities.size(); ++i) {
    const Entity& e = whole.entities[i];
    if (e.fixed) continue;
    Plan::GroupUse& use = uses[e.group];
    (up.entity_level[i] ? use.kept : use.dropped).push_back(e.name);
    if (up.entity_level[i] && !is_output[i] && use.serves.empty())
      use.serves = whole.entities[up.serves[i]].name;
  }
  return uses;
}

}  // namespace

Level Plan::level() const {
  Level highest = Level::position;
  for (const Output& output : outputs) highest = std::max(highest, output.level);
  return highest;
}

Plan make_plan(const Model& whole, std::span<const Output> outputs, PlanExtent extent) {
  std::vector<Output> everything;
  if (outputs.empty()) {
    for (EntityId e = 0; e < static_cast<EntityId>(whole.entities.size()); ++e)
      if (!whole.entities[e].internal) everything.push_back({e, Level::acceleration});
    outputs = everything;
  }
  for (const Output& output : outputs)
    if (output.entity < 0 || output.entity >= static_cast<EntityId>(whole.entities.size()))
      throw std::invalid_argument("a request names entity " + std::to_string(output.entity) +
                                  ", which the model does not have");
  Upstream up(whole);
  for (const Output& output : outputs) up.need_output(output);
  if (extent == PlanExtent::left_out_equations) up.need_left_out_equations();
  if (extent == PlanExtent::mechanism) up.need_mechanism();
  up.keep_consequences();

  Plan plan;
  const Members needed = needed_members(whole, up);
  plan.model = model_of(whole, needed);
  for (const EntityId e : needed.entities)
    if (const Entity& entity = whole.entities[e]; !entity.fixed)
      plan.levels.insert(plan.levels.end(), entity.size, *up.entity_level[e]);
  for (const Output& output : outputs)
    plan.outputs.push_back({position_in(needed.entities, output.entity), output.level});
  plan.groups = describe_use(whole, up, outputs);
  return plan;
}

}  // namespace desmo
