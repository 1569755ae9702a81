#include "bench/experiments/instructions/claims.h"

#include <array>
#include <map>
#include <string_view>
#include <utility>

namespace desmo::instructions {

namespace {

constexpr std::array<std::pair<std::string_view, std::int64_t>, 7> prototype{
    {{"global_automatic_klu", 1'400'000},
     {"global_automatic_umfpack", 12'200'000},
     {"global_automatic_cholmod", 5'100'000},
     {"group_automatic_klu", 1'200'000},
     {"group_automatic_lapack", 6'100'000},
     {"group_symbolic_klu", 930'000},
     {"group_symbolic_lapack", 5'900'000}}};

constexpr std::array<std::string_view, 6> algebras{"klu",     "lapack",  "eigen",
                                                   "umfpack", "cholmod", "ma27"};

/// What was counted, and what contradicts a claim about it.
class Claims {
 public:
  explicit Claims(const std::vector<StepCount>& counts) {
    for (const StepCount& c : counts) counts_[{c.case_name, c.id}] = c.instructions;
  }

  /// Nothing where either was not counted.
  void must_beat(const std::string& case_name, const std::string& faster,
                 const std::string& slower) {
    const auto a = counts_.find({case_name, faster}), b = counts_.find({case_name, slower});
    if (a != counts_.end() && b != counts_.end() && a->second >= b->second)
      broken.push_back(case_name + ": " + faster + " does not beat " + slower);
  }

  std::vector<std::string> broken;

 private:
  std::map<std::pair<std::string, std::string>, std::int64_t> counts_;
};

}  // namespace

std::optional<std::int64_t> of_prototype(const StepCount& count) {
  if (count.case_name == "truck_suspension" && count.coordinates == 558)
    for (const auto& [id, instructions] : prototype)
      if (id == count.id) return instructions;
  return std::nullopt;
}

std::vector<std::string> broken_claims(const std::vector<StepCount>& counts) {
  const std::string truck = "truck_suspension", bars = "four_bar",
                    inlined = "group_symbolic_inlined", in_order = "group_symbolic_explicit";
  Claims claims(counts);
  for (const std::string_view view : algebras) {
    const std::string algebra(view);
    claims.must_beat(truck, "group_symbolic_" + algebra, "group_automatic_" + algebra);
    for (const char* solver : {"group_symbolic_", "global_symbolic_"})
      claims.must_beat(bars, inlined, solver + algebra);
  }
  for (const std::string& name : {truck, bars}) claims.must_beat(name, in_order, inlined);
  for (const StepCount& c : counts)
    if (const auto early = of_prototype(c); early && 10 * c.instructions > 11 * *early)
      claims.broken.push_back(c.name() + " takes more than a tenth more than the prototype");
  return claims.broken;
}

}  // namespace desmo::instructions
