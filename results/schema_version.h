#pragma once

namespace desmo {

/// Version of record.schema.json and check.schema.json. bench/ writes it, and report/ knows it in
/// full; CHANGELOG.md says what it promises.
inline constexpr const char* schema_version = "3.0.0";

}  // namespace desmo
