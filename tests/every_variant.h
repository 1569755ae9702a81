#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "formulations/algebra/backend.h"
#include "formulations/id.h"
#include "formulations/variants.h"
#include "tests/refusal.h"

namespace desmo {

/// Prints a variant in test names and failures.
inline void PrintTo(const Variant& v, std::ostream* out) { *out << v.id; }

/// Returns the variants that tests go through: all of the table, or with sanitizers one for each
/// kind of code. A kind is a partition and equations with one dense, one sparse and each generated
/// algebra; every library and the choice among them occur once more, in global_automatic.
inline std::vector<Variant> tested_variants() {
  const auto all = variants();
  if (!DESMO_SANITIZED) return {all.begin(), all.end()};
  std::vector<Variant> chosen;
  std::set<std::tuple<Partition, Evaluation, std::string_view>> kinds;
  for (const Variant& v : all) {
    const Backend* const library = find_backend(v.algebra);
    const std::string_view kind = !library ? v.algebra : library->dense ? "dense" : "sparse";
    const bool names_a_library = v.id.starts_with("global_automatic_");
    if (kinds.emplace(v.partition, v.evaluation, kind).second || names_a_library)
      chosen.push_back(v);
  }
  return chosen;
}

/// A fixture of tests that run once per variant. Each file has one of its own, by EVERY_VARIANT.
class EveryVariant : public testing::TestWithParam<Variant> {
 public:
  static std::string name(const testing::TestParamInfo<Variant>& info) { return info.param.id; }

 protected:
  /// Returns the variant's id with these suffixes; empty where it does not offer them.
  static std::string offered_id(const std::string& suffixes) {
    const std::string id = GetParam().id + suffixes;
    return refusal([&] { parse_id(id); }) == "accepted" ? id : "";
  }
};

/// Declares a fixture whose tests run for tested_variants(): EVERY_VARIANT(EveryPlan).
#define EVERY_VARIANT(Fixture)            \
  class Fixture : public EveryVariant {}; \
  INSTANTIATE_TEST_SUITE_P(Table, Fixture, testing::ValuesIn(tested_variants()), EveryVariant::name)

}  // namespace desmo
