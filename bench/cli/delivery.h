// From solved instants to the output.
#pragma once

#include <exception>
#include <memory>
#include <optional>
#include <string>

#include "bench/cli/output.h"
#include "bench/cli/progress.h"
#include "bench/cli/series.h"
#include "formulations/verification/branch_monitor.h"

namespace desmo::cli {

/// An instant was solved, but is not what was asked for.
struct NotToDeliver {
  int index;         ///< of the instant
  std::string what;  ///< "constraint 'theta: definition', t = 0.3 s: solved on another branch …"
};

/// Writes each instant it is handed, some at a time. Stops the run where Output throws, where
/// BranchMonitor finds something violated, and where a number is not finite.
class Delivery final : public Observer {
 public:
  /// tolerance: to which positions are solved. The plan must outlive the delivery.
  Delivery(SeriesHeading heading, std::unique_ptr<SeriesFormat> format, const Plan& plan,
           double tolerance, Output& output, Progress& progress);

  Flow observe(const Instant& instant) noexcept override;
  /// Returns the instant that was not to deliver, those before it written. Throws what Output threw
  /// in the run.
  const std::optional<NotToDeliver>& wrong() const;
  /// Writes what has been handed to it but not written.
  void flush();

 private:
  SeriesHeading heading_;
  std::unique_ptr<SeriesFormat> format_;
  Output& output_;
  Progress& progress_;
  const Plan& plan_;
  BranchMonitor monitor_;
  std::string text_;
  std::optional<NotToDeliver> wrong_;
  std::exception_ptr unwritable_;
};

}  // namespace desmo::cli
