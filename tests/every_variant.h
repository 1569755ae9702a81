#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "formulations/variants.h"

namespace desmo {

/// How a test's name and its failures show a variant.
inline void PrintTo(const Variant& v, std::ostream* out) { *out << v.id; }

/// A test for each row of the table of variants.
class EveryVariant : public testing::TestWithParam<Variant> {
 public:
  static std::string name(const testing::TestParamInfo<Variant>& info) { return info.param.id; }
};

}  // namespace desmo
