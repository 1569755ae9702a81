#include "report/statistics/variants.h"

#include <algorithm>

namespace desmo::report {
namespace {

std::string replaced(std::string_view text, std::string_view from, std::string_view to) {
  std::string result(text);
  if (const auto at = result.find(from); at != std::string::npos)
    result.replace(at, from.size(), to);
  return result;
}

}  // namespace

std::string family_name(const PaperVariant& variant, std::string_view family) {
  return replaced(variant.paper_name, "MA27", family);
}

CandidateKey family_key(const PaperVariant& variant, std::int64_t coordinates,
                        std::string_view family) {
  return {std::string(variant.case_name), coordinates, replaced(variant.id, "<sparse>", family)};
}

bool is_reference(const Configuration& configuration) {
  const std::string_view begin = "global_automatic_", id = configuration.formulation;
  return configuration.has_papers_algorithm() && id.starts_with(begin) &&
         std::ranges::count(sparse_families, id.substr(begin.size())) > 0;
}

std::string algebra_kind(std::string_view id) {
  const std::string_view base = without_settings(id), name = base.substr(base.rfind('_') + 1);
  if (std::ranges::count(dense_families, name) > 0) return "dense";
  return name == "inlined" || name == "explicit" ? "generated" : "sparse";
}

std::string_view setting(std::string_view id, std::string_view name) {
  const std::string begin = "/" + std::string(name) + ":";
  const auto at = id.find(begin);
  if (at == std::string_view::npos) return {};
  id.remove_prefix(at + begin.size());
  return id.substr(0, id.find('/'));
}

std::string without_setting(std::string id, const std::string& name) {
  const std::size_t begin = id.find("/" + name + ":");
  if (begin == id.npos) return id;
  const std::size_t end = std::min(id.find('/', begin + 1), id.size());
  return id.erase(begin, end - begin);
}

bool is_beside(const Peer& peer, std::string_view id) {
  return has_settings(id) && id.substr(id.find('/')) == "/guess:" + peer.guess;
}

bool is_beside_peers(const Record& record, std::string_view id) {
  return std::ranges::any_of(record.peers, [&](const Peer& peer) { return is_beside(peer, id); });
}

}  // namespace desmo::report
