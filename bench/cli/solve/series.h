// Solved instants as text: a table of numbers, one line for each instant.
#pragma once

#include <exception>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "bench/cli/solve/columns.h"
#include "bench/kit/process/progress.h"
#include "cases/io/new_files.h"
#include "formulations/base/observer.h"

namespace desmo::cli {

/// Properties of a series apart from its numbers.
struct SeriesHeading {
  std::string mechanism, scene, formulation;
  std::vector<Column> columns;  ///< the time, which comes first, left out
  std::string remark;           ///< name of a last column of words; empty: there is none
  TimeGrid grid{};              ///< whose times are written as they were asked for
};

/// Text format of a series. Other numbers have the fewest digits that read back as the same double.
class SeriesFormat {
 public:
  virtual ~SeriesFormat() = default;
  virtual std::string heading(const SeriesHeading& heading) const = 0;
  /// Finite numbers: JSON knows no others. Without positions only what is fixed has a value.
  virtual void append(const SeriesHeading& heading, const Instant& instant, std::string& text,
                      std::string_view remark = {}) const = 0;
};

/// Returns a format. "csv" has names with units in the first line, "t [s],C.x [m],…". "jsonl" has
/// an object with mechanism, scene, formulation and columns, then an array of numbers for each
/// instant.
std::unique_ptr<SeriesFormat> series_format(std::string_view name);

/// Observer that writes each instant, in blocks of text. It stops the run when the output throws or
/// a number is not finite.
class SeriesWriter final : public Observer {
 public:
  /// measures: those of its columns
  SeriesWriter(SeriesHeading heading, Measures& measures, std::unique_ptr<SeriesFormat> format,
               OutputFile& output, bench::Progress* progress);

  /// Sets the remark on the instant that is observed next; it must outlive that.
  void remark_next(std::string_view remark) { remark_ = remark; }
  Flow observe(const Instant& solved) noexcept override;
  /// Returns overflow_text() of the number that was not finite and ended the run; empty: none.
  /// Throws the exception that the output threw during the run.
  const std::string& overflow() const;
  /// Writes the instants that were received but not written.
  void flush();

 private:
  SeriesHeading heading_;
  Measures& measures_;
  std::unique_ptr<SeriesFormat> format_;
  OutputFile& output_;
  bench::Progress* progress_;
  std::string text_, overflow_;
  std::string_view remark_;
  std::exception_ptr unwritable_;
};

}  // namespace desmo::cli
