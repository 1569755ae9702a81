// The report of a record, and the site of the reports of all records.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "cases/io/new_files.h"
#include "report/read/record.h"
#include "report/text/document.h"

namespace desmo::report {

/// Returns the report of a record: the sections of its experiments, and how they were measured. The
/// same records give the same document.
/// - beside: records of other machines. The speed-ups of those that measured the same stand next to
///   the record's own; where none did, a section says so
Document make_report(const Record& record, const std::vector<const Record*>& beside = {});

/// Returns the speed-ups of a record next to those of others that measured the same on another
/// machine. Each is relative to the reference in its own record (reference_of()). Of each machine
/// the record with the most speed-ups in common is taken. The section has no tables where no other
/// record measured the same.
Section machines(const Record& record, const std::vector<const Record*>& others);

/// Returns the files of a static site by folder. Throws InputError, MixedRecord or UnreadableFile.
/// - for each record in results/records: its page and figures, next to the other records
/// - "history", where there is results/history.json: its page and figure
/// - "": index.html, which selects by machine and date
std::map<std::string, std::vector<NewFile>> make_site(const std::filesystem::path& results);

}  // namespace desmo::report
