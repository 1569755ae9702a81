#include "formulations/codegen/record/sampled_type.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "formulations/constraints/constraints.h"

namespace desmo::generate {

SampledType& add_part(const Model& m, const PartDefinition& part,
                      std::span<const std::vector<double>> states,
                      std::vector<SampledType>& found) {
  constexpr std::size_t pivot_samples = 12;
  const std::size_t stride = std::max<std::size_t>(1, (states.size() + 3) / pivot_samples);
  PartType type = describe_type(m, part);
  std::vector<SamplePoint> samples;
  for (const std::vector<double>& state : states) {
    SamplePoint& sample = samples.emplace_back();
    for (const PartType::Input& input : type.inputs) sample.q.push_back(state[input.state]);
    sample.constants = type.constants;
  }
  auto it = std::ranges::find(found, type.fingerprint,
                              [](const SampledType& t) { return t.type.fingerprint; });
  if (it == found.end()) it = found.insert(it, {"", std::move(type), {}, {}});
  for (std::size_t i = 0; i < samples.size(); i += stride) it->pivot_samples.push_back(samples[i]);
  std::ranges::move(samples, std::back_inserter(it->samples));
  return *it;
}

PartType without_names(PartType type) {
  for (std::size_t i = 0; i < type.inputs.size(); ++i) {
    PartType::Input& input = type.inputs[i];
    input.name = "ukf"[static_cast<int>(input.role)] + std::to_string(i);
  }
  std::size_t row = 0;
  for (std::size_t i = 0; i < type.constraints.size(); ++i)
    visit_kind(type.constraints[i].kind, [&](auto kind) {
      const std::string name = std::string(kind.name) + "#" + std::to_string(i);
      for (std::size_t k = 0; k < type.constraints[i].rows.size(); ++k)
        type.row_names[row++] = name;
    });
  return type;
}

}  // namespace desmo::generate
