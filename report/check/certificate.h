// What the trials of bench/check --certify show of the check itself.
#pragma once

#include <filesystem>

#include "report/document.h"

namespace desmo::report {

struct Certificate {
  bool holds = false;    ///< every claim, with all its trials
  bool refuted = false;  ///< some claim, whatever trials are missing
  Document document;
};

/// Reads the trials, a line each: {"trial": {"kind", "load", "cell"?}, "check": ...}, blank lines
/// aside, and judges each check anew. Throws InvalidRecord, naming the line; MixedRecord when
/// trials are of different machines or compilers; UnreadableFile.
Certificate read_certificate(const std::filesystem::path& file);

}  // namespace desmo::report
