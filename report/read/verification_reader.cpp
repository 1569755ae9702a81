#include "report/read/verification_reader.h"

namespace desmo::report {

Status read_status(const JsonNode& node) {
  const std::string status = node.text();
  if (status == "ok") return Status::ok;
  if (status == "failed") return Status::failed;
  if (status == "not_run") return Status::not_run;
  node.complain("\"" + status + "\" is none of \"ok\", \"failed\", \"not_run\"");
}

Verification read_verification(const JsonNode& node) {
  return {node["instants"].integer(1), node["position"].not_negative(),
          node["velocity"].not_negative(), node["acceleration"].not_negative()};
}

}  // namespace desmo::report
