#pragma once

namespace desmo::bench {

/// Version of results/record.schema.json and results/check.schema.json that is written.
inline constexpr const char* schema_version = "2.0.0";

}  // namespace desmo::bench
