#include "report/check/command.h"

#include <iostream>

#include "report/check/check_outcome.h"
#include "report/check/trials.h"
#include "report/formats/formats.h"

namespace desmo::report {
namespace {

constexpr int usage_error = 64;

int code(CheckVerdict verdict) { return static_cast<int>(verdict); }

/// Runs a command. Returns its exit code, or that of a file that cannot be used, with a message.
template <class Work>
int reporting_errors(const Work& work) {
  const auto failed = [](const InputError& error, int code) {
    std::cerr << "desmo_report: " << error.what() << "\n";
    return code;
  };
  try {
    return work();
  } catch (const UnreadableRecord& error) {
    return failed(error, usage_error);
  } catch (const MixedRecord& error) {
    return failed(error, code(CheckVerdict::incomparable));
  } catch (const UnsupportedVersion& error) {
    return failed(error, code(CheckVerdict::incomparable));
  } catch (const InputError& error) {
    return failed(error, code(CheckVerdict::invalid));
  }
}

}  // namespace

int run(const CheckCommand& command) {
  return reporting_errors([&] {
    const CheckRecord check = read_check(command.file);
    std::optional<CheckRecord> baseline;
    if (!command.baseline.empty()) baseline = read_check(command.baseline);
    const CheckOutcome found = compare_sides(check, baseline ? &*baseline : nullptr);
    if (command.pending) {
      std::string lines;
      for (const Pending& p : pending(found)) lines += p.pass + " " + p.candidate + "\n";
      write_standard_output(lines);
      return code(CheckVerdict::pass);
    }
    write_standard_output(printed(verdict_document(check, found), {command.format}));
    return code(found.verdict);
  });
}

int run(const CertificateCommand& command) {
  return reporting_errors([&] {
    if (!command.added.empty()) {
      add_trial(command.file, command.added);
      return code(CheckVerdict::pass);
    }
    const CheckCertificate certificate = read_certificate(command.file);
    write_standard_output(printed(certificate.document, {command.format}));
    if (certificate.holds) return code(CheckVerdict::pass);
    return code(certificate.refuted ? CheckVerdict::regression : CheckVerdict::inconclusive);
  });
}

}  // namespace desmo::report
