#include "formulations/runtime/wanted_types.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "formulations/codegen/record/recording.h"
#include "formulations/model/part_type.h"
#include "formulations/motion/internals.h"
#include "formulations/runtime/unavailable.h"

namespace desmo::load {

namespace {

using generate::LibraryContents, generate::sample_count, generate::SampledType;

constexpr int max_steps = 400;      // largest number of steps of a motion that is solved here
constexpr double tolerance = 1e-6;  // of sampled states: only magnitudes of their numbers count
/// Largest number of unknowns of a part with generated code. The work of the generator and of the
/// compiler grows faster than this number.
constexpr std::size_t max_unknowns = 100;
/// Largest numbers of samples and of pivot samples of a type: more would tell nothing new.
constexpr std::size_t max_samples = 4 * sample_count, max_pivot_samples = 48;

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

/// Returns a grid over the same time with at most max_steps steps.
TimeGrid with_few_steps(TimeGrid grid) {
  if (grid.instants - 1 > max_steps) {
    grid.step = (grid.instants - 1) * grid.step / max_steps;
    grid.instants = max_steps + 1;
  }
  return grid;
}

/// An observer that keeps at most sample_count states, spread evenly over the instants.
class Sampler final : public Observer {
 public:
  Sampler(const Model& model, int instants) : m_(model), instants_(instants) {}

  Flow observe(const Instant& instant) noexcept override {
    const int samples = static_cast<int>(states.size());
    if (instant.index < (instants_ - 1) * samples / (sample_count - 1)) return Flow::go_on;
    states.push_back(m_.state_of(instant.q));
    return Flow::go_on;
  }

  std::vector<std::vector<double>> states;

 private:
  const Model& m_;
  int instants_;
};

/// Returns states of a model (q, then the fixed values) spread over its motion, as samples for code
/// generation. They are approximate, and large steps may reach another branch than the motion's.
/// The list ends where the motion cannot be followed; it is empty when the model cannot be
/// assembled.
std::vector<std::vector<double>> sample_motion(const Model& m, const TimeGrid& grid) {
  const TimeGrid coarse = with_few_steps(grid);
  Sampler sampler(m, coarse.instants);
  const auto f = make_formulation(find_variant("group_automatic_klu"), m,
                                  {.tolerance = tolerance, .coordinates = m.modelling});
  // Where the run fails, the states before remain.
  static_cast<void>(f->run(coarse, Request{Level::position}, sampler));
  return std::move(sampler.states);
}

/// An observer that notes for each part of a formulation whether its generated code refused a step,
/// up to the last instant that was solved.
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

/// Returns the parts whose code refuses steps of the motion: code that was made for another
/// mechanism, with pivots and closed forms that suit that one.
std::vector<PartDefinition> parts_refused(const Variant& v, const Model& m, const TimeGrid& grid,
                                          const KernelTable& table) {
  std::vector<PartDefinition> result;
  if (!v.is_generated()) return result;
  const auto f = make_formulation(v, m, {.coordinates = m.modelling}, table);
  RefusalObserver observer(*f);
  static_cast<void>(f->run(with_few_steps(grid), Request{Level::velocity}, observer));
  for (std::size_t i = 0; i < observer.refused.size(); ++i)
    if (observer.refused[i]) result.push_back(parts_of(*f)[i].definition);
  return result;
}

}  // namespace

std::vector<SampledType> wanted_types(const Variant& v, LibraryContents contents, const Model& m,
                                      const TimeGrid& grid, const KernelTable& table,
                                      GenerationOutcome& told) {
  std::vector<PartDefinition> parts = parts_without_code(v, contents, m, table);
  std::ranges::move(parts_refused(v, m, grid, table), std::back_inserter(parts));
  const std::size_t too_large = std::erase_if(
      parts, [](const PartDefinition& part) { return part.unknowns.size() > max_unknowns; });

  std::vector<std::vector<double>> states;
  if (!parts.empty()) states = sample_motion(m, grid);
  if (!parts.empty() && states.empty()) throw Unavailable("the mechanism cannot be assembled");
  told.parts_too_large = static_cast<int>(too_large);
  std::vector<SampledType> types;
  std::vector<TypeUse> uses;  // use of each type
  for (const PartDefinition& part : parts) {
    SampledType& type = generate::add_part(m, part, states, types);
    if (type.name.empty()) {
      type.name = "type_" + std::to_string(types.size() - 1);
      type.type = generate::without_names(std::move(type.type));
      uses.push_back({m.groups[part.groups.front()].name, static_cast<int>(part.unknowns.size())});
    }
    type.samples.resize(std::min(type.samples.size(), max_samples));
    type.pivot_samples.resize(std::min(type.pivot_samples.size(), max_pivot_samples));
    ++uses[&type - types.data()].parts;
  }
  told.types = std::move(uses);
  return types;
}

}  // namespace desmo::load
