// A static site of all filed records.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cases/io/new_files.h"

namespace desmo::report {

/// A page of the site with its figures, in a folder of its own; empty: beside these folders.
struct SitePage {
  std::string folder;
  std::vector<NewFile> files;
};

/// Returns a page for every record in results/records, the others beside it (report.h), one for
/// results/history.json where it is, and an index.html that selects by machine and date. Throws
/// InputError, or MixedRecord.
std::vector<SitePage> make_site(const std::filesystem::path& results);

}  // namespace desmo::report
