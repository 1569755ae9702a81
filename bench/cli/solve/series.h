// Solved instants as text: a table of numbers, one line for each instant.
#pragma once

#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "bench/cli/solve/columns.h"
#include "bench/kit/process/progress.h"
#include "cases/io/new_files.h"
#include "formulations/base/observer.h"

namespace desmo::cli {

/// Text format of a series. Numbers have the fewest digits that read back as the same double.
enum class SeriesFormat {
  csv,    ///< names with units in the first line, "t [s],C.x [m],…"
  jsonl,  ///< an object with mechanism, scene, formulation and columns, then arrays of numbers
};

/// Properties of a series, its numbers excepted.
struct SeriesHeading {
  SeriesFormat format;
  std::string mechanism, scene, formulation;
  std::vector<Column> columns;  ///< columns after the first, which is the time
  std::string remark;           ///< name of a last column of words; empty: there is none
  TimeGrid grid{};              ///< its times are written as decimals: 0.3 for the double 3 · 0.1
};

/// Returns the first line.
std::string first_line(const SeriesHeading& heading);

/// Appends the line of an instant. NaN becomes a missing number; infinite numbers, which JSON does
/// not know, must not be among those of the columns. Without positions, only constants have a
/// value.
void append_line(const SeriesHeading& heading, const Instant& instant, std::string_view remark,
                 std::string& text);

/// Observer that writes each instant, in blocks of text. It stops the run when the output throws or
/// a number is not finite. NaN is a missing number, and no reason to stop, where a column may lack
/// numbers, and for rates of a flagged row.
class SeriesWriter final : public Observer {
 public:
  /// heading: must outlive the writer; measures: those whose columns it has
  SeriesWriter(const SeriesHeading& heading, Measures& measures, OutputFile& output,
               bench::Progress* progress);

  /// Sets the remark on the instant that is observed next. The text must last until then.
  void remark_next(std::string_view remark) { remark_ = remark; }
  Flow observe(const Instant& solved) noexcept override;
  /// Returns overflow_text() of the number that was not finite and ended the run; empty: none.
  /// Throws the exception that the output threw during the run.
  const std::string& overflow() const;
  /// Writes the instants that were received but not written.
  void flush();

 private:
  const SeriesHeading& heading_;
  Measures& measures_;
  OutputFile& output_;
  bench::Progress* progress_;
  std::string text_, overflow_;
  std::string_view remark_;
  std::exception_ptr unwritable_;
};

}  // namespace desmo::cli
