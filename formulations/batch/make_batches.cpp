#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "cases/mechanism/disjoint_sets.h"
#include "formulations/batch/batch_part.h"
#include "formulations/model/partition.h"
#include "formulations/parts/explicit_part.h"

namespace desmo {

namespace {

/// Positions of parts in the order of solution.
using Positions = std::vector<int>;

class BatchMaker {
 public:
  BatchMaker(const Model& model, std::vector<DefinedPart> parts, const std::vector<int>& type_ends,
             const Settings& settings, const KernelTable& table)
      : model_(model),
        parts_(std::move(parts)),
        lanes_(settings.lanes),
        guess_(settings.guess),
        table_(table),
        kinds_(model.state_size(), StateKind::constant) {
    for (int range = 0; range < static_cast<int>(type_ends.size()); ++range)
      range_of_.resize(type_ends[range], range);
    std::fill_n(kinds_.begin(), model.coordinates(), StateKind::solved);
    for (const DefinedPart& part : parts_)
      if (part.definition.constant)
        for (const int i : part.definition.unknowns) kinds_[i] = StateKind::constant;
    for (const Driver& d : model.drivers)
      kinds_[model.entities[d.coordinate].first] = StateKind::driven;
  }

  /// Returns the parts, with batches in place of those that they solve; the maker is then empty.
  std::vector<DefinedPart> make() {
    Positions left;
    for (int i = 0; i < size(); ++i)
      if (parts_[i].definition.constant) left.push_back(i);
    for (const std::vector<Positions>& subsystems : alike_subsystems()) {
      std::span<const Positions> rest = subsystems;
      for (const std::size_t together : {subsystems.size(), subsystems.size() / lanes_ * lanes_})
        if (gains(subsystems, together)) {
          put(rest.first(together));
          rest = rest.subspan(together);
          break;
        }
      for (const Positions& subsystem : rest)
        left.insert(left.end(), subsystem.begin(), subsystem.end());
    }
    std::ranges::sort(left);
    return by_types(left);
  }

 private:
  int size() const { return static_cast<int>(parts_.size()); }

  /// Returns the parts at these positions; an empty list where one is not in explicit order.
  std::vector<const ExplicitPart*> explicit_parts(const Positions& positions) const {
    std::vector<const ExplicitPart*> result;
    for (const int i : positions)
      result.push_back(dynamic_cast<const ExplicitPart*>(parts_[i].solver.get()));
    if (std::ranges::find(result, nullptr) != result.end()) result.clear();
    return result;
  }

  /// Returns the subsystems: sets of moving parts that need each other, directly or by way of
  /// others. Each list has subsystems that are alike.
  std::vector<std::vector<Positions>> alike_subsystems() const {
    DisjointSets linked(parts_.size());
    Positions owner(model_.state_size(), -1);
    for (int i = 0; i < size(); ++i) {
      const PartDefinition& part = parts_[i].definition;
      if (part.constant) continue;
      for (const int state : states_read(model_, part))
        if (const int needed = owner[state]; needed >= 0) linked.unite(needed, i);
      for (const int unknown : part.unknowns) owner[unknown] = i;
    }
    std::map<int, Positions> subsystems;
    for (int i = 0; i < size(); ++i)
      if (!parts_[i].definition.constant) subsystems[linked.find(i)].push_back(i);
    std::vector<std::vector<Positions>> kinds;
    for (const auto& [number, subsystem] : subsystems) {
      const auto kind = std::ranges::find_if(
          kinds, [&](const auto& alike) { return are_alike(alike.front(), subsystem); });
      (kind != kinds.end() ? *kind : kinds.emplace_back()).push_back(subsystem);
    }
    return kinds;
  }

  bool are_alike(const Positions& a, const Positions& b) const {
    const std::vector<const ExplicitPart*> of_a = explicit_parts(a), of_b = explicit_parts(b);
    return !of_a.empty() && !of_b.empty() && desmo::are_alike(of_a, of_b);
  }

  /// Returns the kernels of a subsystem's parts for each number of lanes, ascending, for which all
  /// exist.
  std::vector<SubsystemKernels> kernels(const Positions& subsystem) const {
    std::vector<SubsystemKernels> result;
    for (const int lanes : lane_counts) {
      SubsystemKernels of_all;
      for (const ExplicitPart* const part : explicit_parts(subsystem))
        if (const LaneKernel* k = table_.find_lane_kernel(part->kernel().fingerprint, lanes))
          of_all.push_back(k);
      if (lanes <= lanes_ && of_all.size() == subsystem.size()) result.push_back(std::move(of_all));
    }
    return result;
  }

  std::size_t calls(std::size_t parts) const { return (parts + lanes_ - 1) / lanes_; }

  /// Compares batches of the first `together` subsystems, with the rest solved type by type, with
  /// solving all subsystems type by type. Returns whether the former takes no more calls of
  /// kernels.
  bool gains(const std::vector<Positions>& subsystems, std::size_t together) const {
    if (together < 2 || kernels(subsystems.front()).empty()) return false;
    std::map<int, std::size_t> of_range;
    for (const int i : subsystems.front()) ++of_range[range_of_[i]];
    std::size_t by_type = 0, by_subsystem = subsystems.front().size() * calls(together);
    for (const auto& [range, parts] : of_range) {
      by_type += calls(parts * subsystems.size());
      by_subsystem += calls(parts * (subsystems.size() - together));
    }
    return by_subsystem <= by_type;
  }

  /// Appends a part to result_ that solves these subsystems in batches.
  void put(std::span<const Positions> subsystems) {
    std::vector<Subsystem> subsystem_parts;
    std::vector<SubsystemKernels> of_subsystem = kernels(subsystems.front());
    DefinedPart all;
    PartDefinition& definition = all.definition;
    definition.constant = parts_[subsystems.front().front()].definition.constant;
    for (const Positions& subsystem : subsystems) {
      subsystem_parts.emplace_back();
      for (const int i : subsystem) {
        DefinedPart& part = parts_[i];
        subsystem_parts.back().emplace_back(static_cast<ExplicitPart*>(part.solver.release()));
        definition.append(part.definition);
        all.as_named = all.as_named && part.as_named;
        all.tolerance = std::hypot(all.tolerance, part.tolerance);
      }
    }
    std::ranges::sort(definition.groups);
    definition.groups.erase(std::ranges::unique(definition.groups).begin(),
                            definition.groups.end());
    std::ranges::sort(definition.unknowns);
    std::ranges::sort(definition.equations);
    all.solver = std::make_unique<BatchPart>(std::move(of_subsystem), std::move(subsystem_parts),
                                             kinds_, guess_);
    result_.push_back(std::move(all));
  }

  /// Returns constant parts, the parts in result_, then the other parts. The parts of a range are
  /// joined in batches where there is code for lanes, and stay single elsewhere.
  std::vector<DefinedPart> by_types(const Positions& left) {
    std::vector<DefinedPart> batches = std::exchange(result_, {});
    for (auto first = left.begin(); first != left.end();) {
      const auto last =
          std::find_if(first, left.end(), [&](int i) { return range_of_[i] != range_of_[*first]; });
      std::vector<Positions> range;
      for (auto i = first; i != last; ++i) range.push_back({*i});
      const bool alike = std::ranges::all_of(
          range, [&](const Positions& one) { return are_alike(range.front(), one); });
      if (range.size() > 1 && alike && !kernels(range.front()).empty())
        put(range);
      else
        for (const Positions& one : range) result_.push_back(std::move(parts_[one.front()]));
      first = last;
    }
    const auto moving = std::ranges::find_if(
        result_, [](const DefinedPart& part) { return !part.definition.constant; });
    result_.insert(moving, std::make_move_iterator(batches.begin()),
                   std::make_move_iterator(batches.end()));
    return std::move(result_);
  }

  const Model& model_;
  std::vector<DefinedPart> parts_;
  const int lanes_;
  const Guess guess_;
  const KernelTable& table_;
  // number of the range of each part; a range has parts of one type that do not need each other
  std::vector<int> range_of_;
  std::vector<StateKind> kinds_;  // origin of each position in the state
  std::vector<DefinedPart> result_;
};

}  // namespace

std::vector<DefinedPart> make_batches(const Model& model, std::vector<DefinedPart> parts,
                                      const std::vector<int>& type_ends, const Settings& settings,
                                      const KernelTable& table) {
  return BatchMaker(model, std::move(parts), type_ends, settings, table).make();
}

}  // namespace desmo
