// Writing of solved instants to the output.
#pragma once

#include <exception>
#include <memory>
#include <string>

#include "bench/cli/solve/series.h"
#include "bench/kit/process/progress.h"
#include "cases/io/new_files.h"
#include "formulations/base/observer.h"

namespace desmo::cli {

/// Observer that writes each instant, in blocks of text. It stops the run when the output throws or
/// a number is not finite.
class SeriesWriter final : public Observer {
 public:
  SeriesWriter(SeriesHeading heading, std::unique_ptr<SeriesFormat> format, OutputFile& output,
               bench::Progress* progress);

  Flow observe(const Instant& instant) noexcept override;
  /// Returns overflow_text() of the number that was not finite and ended the run; empty: none.
  /// Throws the exception that the output threw during the run.
  const std::string& overflow() const;
  /// Writes the instants that were received but not written.
  void flush();

 private:
  SeriesHeading heading_;
  std::unique_ptr<SeriesFormat> format_;
  OutputFile& output_;
  bench::Progress* progress_;
  std::string text_, overflow_;
  std::exception_ptr unwritable_;
};

}  // namespace desmo::cli
