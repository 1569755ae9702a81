#include "report/check/command.h"

#include <iostream>

#include "report/check/certificate.h"
#include "report/check/check_outcome.h"
#include "report/check/check_reader.h"
#include "report/check/trials.h"
#include "report/check/verdict.h"
#include "report/formats/formats.h"
#include "report/output_files.h"
#include "report/read/json_document.h"

namespace desmo::report {
namespace {

constexpr int usage_error = 64;

int code(Verdict verdict) { return static_cast<int>(verdict); }

std::string printed(const Document& document, const std::string& format) {
  std::string text;
  for (const Rendered& file : render(document, format)) text += file.content;
  return text;
}

int judged(const CheckCommand& command, std::string& reading) {
  const CheckRecord check = read_check(reading = command.file);
  const CheckOutcome found = command.baseline.empty()
                                 ? compare_sides(check)
                                 : compare_sides(check, read_check(reading = command.baseline));
  if (command.pending) {
    std::string lines;
    for (const Pending& p : pending(found)) lines += p.pass + " " + p.candidate + "\n";
    write_standard_output(lines);
    return 0;
  }
  write_standard_output(printed(verdict_document(check, found), command.format));
  return code(found.verdict);
}

int certified(const CertificateCommand& command, std::string& reading) {
  if (!command.added.empty()) {
    add_trial(command.file, reading = command.added);
    return code(Verdict::pass);
  }
  const Certificate certificate = read_certificate(reading = command.file);
  write_standard_output(printed(certificate.document, command.format));
  if (certificate.holds) return code(Verdict::pass);
  return code(certificate.refuted ? Verdict::regression : Verdict::inconclusive);
}

/// What goes wrong with a file is told of the one that was being read.
template <class Work>
int reporting_errors(const Work& work) {
  std::string reading;
  const auto failed = [&reading](const InvalidRecord& error, int code) {
    std::cerr << "desmo_report: " << reading << ": " << error.what() << "\n";
    return code;
  };
  try {
    return work(reading);
  } catch (const UnreadableFile& error) {
    return failed(error, usage_error);
  } catch (const MixedRecord& error) {
    return failed(error, code(Verdict::incomparable));
  } catch (const UnsupportedVersion& error) {
    return failed(error, code(Verdict::incomparable));
  } catch (const InvalidRecord& error) {
    return failed(error, code(Verdict::invalid));
  }
}

}  // namespace

int run(const CheckCommand& command) {
  return reporting_errors([&](std::string& reading) { return judged(command, reading); });
}

int run(const CertificateCommand& command) {
  return reporting_errors([&](std::string& reading) { return certified(command, reading); });
}

}  // namespace desmo::report
