// The report of a record, and a site of those of all records.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "cases/io/new_files.h"
#include "report/read/record.h"
#include "report/text/document.h"

namespace desmo::report {

/// Returns the page of a record: the sections of what it has measured, and how it was measured.
/// beside: records of other machines. Those that measured the same have their speed-ups next to the
/// record's own; where none did, a section says so. The same records give the same document.
Document make_report(const Record& record, const std::vector<const Record*>& beside = {});

/// Returns the speed-ups of a record next to those of others that measured the same on another
/// machine, each over the usual reference in its own record: of each machine the record that has
/// most in common. The section has no tables where no other record measured the same.
Section machines(const Record& record, const std::vector<const Record*>& others);

/// Returns the files of a static site by folder: a page with its figures for every record in
/// results/records, the others next to it, one for results/history.json where it is, and in the
/// folder "" an index.html that selects by machine and date. Throws InputError, or MixedRecord.
std::map<std::string, std::vector<NewFile>> make_site(const std::filesystem::path& results);

}  // namespace desmo::report
