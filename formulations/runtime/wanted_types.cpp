#include "formulations/runtime/wanted_types.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "formulations/runtime/motion_samples.h"
#include "formulations/runtime/unavailable.h"
#include "formulations/stepping/formulation_core.h"
#include "formulations/structure/part_type.h"

namespace desmo::load {

namespace {

using generate::LibraryContents, generate::SampledType;

/// The work of a generator and a compiler grows faster than the size of a part.
constexpr std::size_t max_unknowns = 100;
/// More than these tell no more of a type.
constexpr std::size_t enough_samples = 4 * generate::sample_count, enough_for_pivots = 48;

bool has_all(const KernelTable& table, const std::string& fingerprint, LibraryContents contents) {
  return table.find_kernel(fingerprint) &&
         (!contents.explicit_order || table.find_explicit_kernel(fingerprint)) &&
         (contents.lanes == 1 || table.find_lane_kernel(fingerprint, contents.lanes));
}

std::vector<PartDefinition> parts_without_code(const Variant& v, LibraryContents contents,
                                               const Model& m, const KernelTable& table) {
  std::vector<PartDefinition> result;
  if (v.evaluation == Evaluation::automatic) return result;
  for (const PartDefinition& part : make_partition(m, v.partition))
    for (PartDefinition& group : split_by_group(m, part))
      if (!has_all(table, describe_type(m, group).fingerprint, contents))
        result.push_back(std::move(group));
  return result;
}

/// Keeps which parts of a formulation refused steps of a motion, as far as it could be solved.
struct RefusalObserver final : Observer {
  explicit RefusalObserver(const Formulation& f) : parts(parts_of(f)), refused(parts.size()) {}

  Flow observe(const Instant&) noexcept override {
    for (std::size_t i = 0; i < parts.size(); ++i)
      refused[i] = parts[i].solver->counts().fallbacks > 0;
    return Flow::go_on;
  }

  const std::vector<DefinedPart>& parts;
  std::vector<bool> refused;
};

/// Returns the parts whose code refuses steps of the motion: it was made for other mechanisms, with
/// pivots and closed forms that suit those.
std::vector<PartDefinition> parts_refused(const Variant& v, const Model& m, const TimeGrid& grid,
                                          const KernelTable& table) {
  std::vector<PartDefinition> result;
  if (!v.is_generated()) return result;
  const auto f = make_formulation(v, m, {}, table);
  RefusalObserver observer(*f);
  static_cast<void>(f->run(with_few_steps(grid), Request{Level::velocity}, observer));
  for (std::size_t i = 0; i < observer.refused.size(); ++i)
    if (observer.refused[i]) result.push_back(parts_of(*f)[i].definition);
  return result;
}

}  // namespace

WantedTypes wanted_types(const Variant& v, LibraryContents contents, const Model& m,
                         const TimeGrid& grid, const KernelTable& table) {
  WantedTypes wanted;
  std::vector<PartDefinition> parts = parts_without_code(v, contents, m, table);
  std::ranges::move(parts_refused(v, m, grid, table), std::back_inserter(parts));
  wanted.parts_too_large = static_cast<int>(std::erase_if(
      parts, [](const PartDefinition& part) { return part.unknowns.size() > max_unknowns; }));
  if (parts.empty()) return wanted;

  const std::vector<std::vector<double>> states = sample_motion(m, grid);
  if (states.empty()) throw Unavailable("the mechanism cannot be assembled");
  std::vector<SampledType>& types = wanted.types;
  for (const PartDefinition& part : parts) {
    SampledType& type = generate::add_part(m, part, states, types);
    if (type.name.empty()) {
      type.name = "type_" + std::to_string(types.size() - 1);
      type.type = generate::without_names(std::move(type.type));
      wanted.uses.push_back(
          {m.groups[part.groups.front()].name, static_cast<int>(part.unknowns.size())});
    }
    type.samples.resize(std::min(type.samples.size(), enough_samples));
    type.pivot_samples.resize(std::min(type.pivot_samples.size(), enough_for_pivots));
    ++wanted.uses[&type - types.data()].parts;
  }
  return wanted;
}

}  // namespace desmo::load
