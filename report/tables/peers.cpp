// The table of peers next to the formulations that start from the same guess.
#include <algorithm>
#include <map>

#include "report/tables/entries.h"
#include "report/tables/record_words.h"
#include "report/tables/tables.h"

namespace desmo::report {
namespace {

/// Our formulations with a peer's guess, at its case and size.
struct Ours {
  std::vector<CandidateKey> all;
  std::optional<CandidateKey> global;   ///< the fastest global formulation
  std::optional<CandidateKey> fastest;  ///< the fastest of all
};

Ours ours_with(const Record& record, const Peer& peer) {
  Ours ours;
  ours.all =
      candidates_at(record, peer.key, [&](const std::string& id) { return is_beside(peer, id); });
  std::vector<CandidateKey> global = ours.all;
  std::erase_if(global, [](const CandidateKey& key) { return !key.id.starts_with("global_"); });
  ours.global = fastest_of(record, global);
  ours.fastest = fastest_of(record, ours.all);
  return ours;
}

/// Ratio time of a peer / time of our fastest formulation.
struct PeerRatio {
  std::string peer;
  SpeedUp times;
};

/// Peers of a case by number of coordinates and guess.
using PeersByGuess = std::map<std::pair<std::int64_t, std::string>, std::vector<const Peer*>>;

/// Returns a sentence on the fastest and the slowest peer, at a case's largest size at which one
/// has a ratio.
std::string found(const Record& record, const std::string& case_name, const PeersByGuess& all) {
  std::int64_t size = 0;
  std::vector<PeerRatio> ratios;
  for (const auto& [place, peers] : all)  // sizes ascend
    for (const Peer* peer : peers) {
      const Measured time = measured(*peer);
      const std::optional<CandidateKey> ours = ours_with(record, *peer).fastest;
      if (!ours || !time.seconds) continue;
      if (place.first > size) ratios.clear();
      size = place.first;
      ratios.push_back({peer->name, speed_up(*time.seconds, *measured(record, *ours).seconds)});
    }
  if (ratios.empty()) return sentence("peers.none");
  const auto [fastest, slowest] =
      std::ranges::minmax(ratios, {}, [](const PeerRatio& ratio) { return ratio.times.value; });
  TextValues words{{"case", case_name},       {"coordinates", size},
                   {"fastest", fastest.peer}, {"least", ratio_text(fastest.times)},
                   {"slowest", slowest.peer}, {"most", ratio_text(slowest.times)}};
  words.emplace_back("slowest_too",
                     fastest.peer == slowest.peer ? "" : sentence("peers.slowest_too", words));
  return sentence("peers.found", words);
}

/// Returns the entry of the ratio time / our time, "6.10 [5.90, 6.32]", quantities {ratio, low,
/// high}. key: candidate or peer that has the time; ours: candidate that has our time.
Entry peer_ratio_entry(const Record& record, const std::optional<CandidateKey>& ours,
                       const CandidateKey& key, const Measured& time) {
  if (ours == key) return reference_entry();
  if (!ours) return note_entry(missing_mark);
  if (!time.seconds) return note_entry(time.mark);
  return ratio_entry(speed_up(*time.seconds, *measured(record, *ours).seconds));
}

void add_solver(Table& table, const Record& record, const Ours& ours, const CandidateKey& key,
                const std::string& name, const Measurement& candidate) {
  const Measured time = measured(candidate);
  std::vector<Entry> row{
      key.coordinates,
      name,
      seconds_entry(time),
      instant_entry(record, time),
      peer_ratio_entry(record, ours.global, key, time),
      peer_ratio_entry(record, ours.fastest, key, time),
      number_entry(time.seconds ? candidate.iterations_per_step : std::nullopt, 3)};
  add_errors(row, candidate);
  row.push_back(remark(candidate));
  table.rows.push_back(std::move(row));
}

}  // namespace

Section peers(const Record& record) {
  Section section = headed_section("peers");
  std::map<std::string, std::string> methods;
  std::map<std::string, PeersByGuess> cases;
  for (const Peer& peer : record.peers) {
    methods[peer.name] = sentence("peers.method", {{"peer", peer.name},
                                                   {"library", peer.library},
                                                   {"version", peer.library_version},
                                                   {"method", peer.method}});
    cases[peer.key.case_name][{peer.key.coordinates, peer.guess}].push_back(&peer);
  }
  if (cases.empty()) return section;
  section.paragraphs = {found(record, cases.rbegin()->first, cases.rbegin()->second)};
  for (const auto& [name, method] : methods) section.definitions.push_back(method);
  for (const auto& [name, places] : cases) {
    Table table = headed_table("peers_case", timed_words(record, {{"case", name}}));
    for (const auto& [place, peers] : places) {
      const Ours ours = ours_with(record, *peers.front());
      for (const Peer* peer : peers) add_solver(table, record, ours, peer->key, peer->name, *peer);
      for (const CandidateKey& key : ours.all)
        add_solver(table, record, ours, key, key.id, record.candidates.at(key));
    }
    section.tables.push_back(std::move(table));
  }
  return section;
}

}  // namespace desmo::report
