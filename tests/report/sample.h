// The synthetic records of tests/report/data and what tests do to them.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "report/document.h"
#include "report/record.h"

namespace desmo::report {

using Json = nlohmann::ordered_json;

std::filesystem::path data_file(const std::string& name);
std::string read_text(const std::filesystem::path& file);

/// data/complete.json: every family, size and status "ok". Made-up numbers.
Json complete_record();

/// data/structured.json: small, with structure and requests (schema 1.2.0). Made-up numbers.
Json structured_record();

/// A cell of such a record. Fails the test when there is none.
Json& cell_of(Json& record, const std::string& case_name, int coordinates, const std::string& id);
void erase_cell(Json& record, const std::string& case_name, int coordinates, const std::string& id);
void fail_cell(Json& record, const std::string& case_name, int coordinates, const std::string& id);

/// Erases every cell with this sparse solver, as of a build without it.
void erase_family(Json& record, const std::string& family);

/// Replaces the samples of a truck cell.
void set_samples(Json& record, int coordinates, const std::string& id, std::vector<double> samples);

Record record_from(const Json& json);

/// The row whose first texts are `labels`, in the column of that name.
Entry entry_at(const Table& table, const std::vector<std::string>& labels,
               const std::string& column);

const Table& table_named(const Document& document, const std::string& name);

}  // namespace desmo::report
