// The part of a record that holds the paper's experiment.
#pragma once

#include "report/read/json_node.h"
#include "report/read/record.h"

namespace desmo::report {

/// Reads the section `paper`: candidates, requests and peers, each once, what the wall clock
/// measured apart; structure and profiles.
///
/// Checks the verification of everything "ok": what exceeds `record.settings.allowed` becomes a
/// failure that says so, and has no time. Throws InvalidRecord.
void read_paper(Record& record, const JsonNode& section);

/// Reads what names a candidate.
CandidateKey read_key(const JsonNode& node);

/// Reads `structure` and `profiles`, each element once, where there are any. Throws InvalidRecord.
void read_structures(Record& record, const JsonNode& section);
void read_profiles(Record& record, const JsonNode& section);

}  // namespace desmo::report
