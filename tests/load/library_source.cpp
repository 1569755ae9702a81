// The text of generated libraries, and tables of several.

#include "formulations/codegen/emit/library_source.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>

#include "formulations/equations/kernel_sets.h"
#include "formulations/equations/kernel_table.h"
#include "formulations/equations/symbolic.h"
#include "tests/mechanisms.h"

namespace desmo::generate::library_source_test {
namespace {

std::vector<SampledType> types_of(const Model& m) {
  std::vector<double> state = m.estimate;
  state.insert(state.end(), m.fixed_values.begin(), m.fixed_values.end());
  std::vector<SampledType> types;
  for (const PartDefinition& part : make_partition(m, Partition::group)) {
    SampledType& type = add_part(m, part, std::vector{state, state}, types);
    if (type.name.empty()) type.name = "type_" + std::to_string(types.size());
  }
  return types;
}

TEST(LibrarySource, IsTheSameEveryTimeAndWholeInItself) {
  const std::vector<SampledType> types = types_of(truck_model(2));
  const std::string source = library_source(types, {true, 4});
  EXPECT_EQ(source, library_source(types, {true, 4}));
  EXPECT_EQ(source.find("#include \""), std::string::npos);
  EXPECT_EQ(source.find("#pragma once"), std::string::npos);
  for (const char* text : {"#include <experimental/simd>", "struct KernelLibrary", "desmo_kernels{",
                           "constexpr LaneKernel lane_table[]", "namespace type_1 {"})
    EXPECT_NE(source.find(text), std::string::npos) << text;
}

TEST(LibrarySource, HoldsWhatIsAskedFor) {
  const std::vector<SampledType> types = types_of(four_bar_model(2));
  const std::string inlined = library_source(types, {}), ordered = library_source(types, {true});
  EXPECT_EQ(inlined.find("constexpr ExplicitKernel"), std::string::npos);
  EXPECT_NE(ordered.find("constexpr ExplicitKernel table[]"), std::string::npos);
  EXPECT_EQ(ordered.find("simd"), std::string::npos) << "it takes a second to compile";
  EXPECT_EQ(library_source({}, {true, 4}), "");
}

TEST(LibrarySource, LeavesOutWhatCannotBeWrittenAndSaysWhy) {
  std::vector<SampledType> types = types_of(four_bar_model(1));
  SampledType singular = types.back();
  singular.name = "singular";
  // One unknown less than equations.
  std::ranges::find(singular.type.inputs, Role::unknown, &PartType::Input::role)->role =
      Role::known;
  types.push_back(singular);
  const std::string source = library_source(types, {});
  EXPECT_NE(source.find("// No singular: the Jacobian is structurally singular"), source.npos);
  EXPECT_EQ(source.find("namespace singular {"), source.npos);
  EXPECT_NE(source.find("namespace type_1 {"), source.npos);
  EXPECT_EQ(library_source({singular}, {}), "");
}

TEST(SampledTypes, CollectWhatPartsOfOneTypeSee) {
  const std::vector<SampledType> types = types_of(four_bar_model(3));
  ASSERT_EQ(types.size(), 2u);
  EXPECT_EQ(types[0].samples.size(), 2u);
  EXPECT_EQ(types[1].samples.size(), 6u) << "three dyads, two states";
  const PartType& type = types[1].type;
  for (const SamplePoint& s : types[1].samples) {
    EXPECT_EQ(s.q.size(), type.inputs.size());
    EXPECT_EQ(s.constants.size(), type.constants.size());
  }
}

TEST(SampledTypes, WithoutNamesAreTheSameForEveryPartOfTheType) {
  const Model m = four_bar_model(2);
  const auto parts = make_partition(m, Partition::group);
  const PartType one = without_names(describe_type(m, parts[1])),
                 other = without_names(describe_type(m, parts[2]));
  ASSERT_EQ(one.fingerprint, other.fingerprint);
  EXPECT_EQ(one.row_names, other.row_names);
  for (std::size_t i = 0; i < one.inputs.size(); ++i) {
    EXPECT_EQ(one.inputs[i].name, other.inputs[i].name);
    EXPECT_EQ(one.inputs[i].name.substr(1), std::to_string(i));
  }
  EXPECT_EQ(one.row_names.size(), static_cast<std::size_t>(one.rows()));
  EXPECT_TRUE(one.row_names.front().ends_with("#0")) << one.row_names.front();
}

TEST(KernelTables, HaveWhatWasAddedBesideWhatIsBuiltIn) {
  const std::string_view built = built_in_kernels().front().kernels.front().fingerprint;
  std::array<Kernel, 2> added{};
  added[0].fingerprint = "own type";
  added[1].fingerprint = built;
  KernelTable table;
  EXPECT_EQ(table.find_kernel("own type"), nullptr);
  table.add(std::make_shared<KernelLibrary>(KernelLibrary{added, {}, {}}));
  ASSERT_EQ(table.find_kernel("own type"), &added[0]);
  EXPECT_EQ(table.find_kernel(built), &added[1]) << "made for the mechanism at hand";
  EXPECT_EQ(table.find_explicit_kernel("own type"), nullptr);
  EXPECT_EQ(table.find_lane_kernel("own type", 4), nullptr);
  EXPECT_EQ(KernelTable::built_in().find_kernel("own type"), nullptr);
}

}  // namespace
}  // namespace desmo::generate::library_source_test
