// What the trials of bench/check --certify show of the check itself.
#pragma once

#include <filesystem>

#include "report/text/document.h"

namespace desmo::report {

struct Certificate {
  bool holds = false;    ///< every claim, with all its trials
  bool refuted = false;  ///< some claim, whatever trials are missing
  Document document;
};

/// Reads the trials (report/check/trials.h) and counts what they show. Throws InvalidRecord, naming
/// the line, and UnreadableFile.
Certificate read_certificate(const std::filesystem::path& file);

}  // namespace desmo::report
