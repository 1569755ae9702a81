// The file of a certificate: where its trials were made, and then a line for each.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "report/text/document.h"

namespace desmo::report {

/// The machine on which trials were made: those of two machines or compilers do not make one
/// certificate.
struct TrialsHead {
  std::string date;  ///< of the first
  std::string cpu, compiler, flags;
  std::int64_t cores = 0;
};

/// A trial: what was done to the check, and what it said.
struct Trial {
  std::string kind, load, candidate;
  std::string verdict;                                 ///< "pass", "regression" ...
  std::vector<std::string> slower, faster, more_work;  ///< candidates that it named
};

struct Trials {
  std::optional<TrialsHead> head;  ///< nothing where there is no trial
  std::vector<Trial> all;
};

/// Reads the text of a certificate, blank lines aside. Throws InputError, naming the line.
Trials read_trials(const std::string& text, const std::string& file = "trials");

/// Judges the check of a trial, {"trial": {"kind", "load", "number", "candidate"}, "check": ...},
/// and adds a line to a certificate, which is begun where there is none.
///
/// Throws InputError; MixedRecord for a trial of another machine or compiler; OutputError.
void add_trial(const std::filesystem::path& certificate, const std::filesystem::path& trial);

struct CheckCertificate {
  bool holds = false;    ///< every claim, with all its trials
  bool refuted = false;  ///< some claim, whatever trials are missing
  Document document;
};

/// Reads the trials (report/check/trials.h) and counts what they show. Throws InputError, naming
/// the line, and UnreadableRecord.
CheckCertificate read_certificate(const std::filesystem::path& file);

}  // namespace desmo::report
