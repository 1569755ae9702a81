// What a user would pick instead: peers beside the formulations that start from the same guess.
#include <algorithm>
#include <map>
#include <set>

#include "report/statistics/measurements.h"
#include "report/statistics/variants.h"
#include "report/tables/entries.h"
#include "report/tables/tables.h"
#include "report/tables/time_words.h"
#include "report/text/digits.h"

namespace desmo::report {
namespace {

using Place = std::pair<std::string, std::int64_t>;  // case and size

Place place_of(const Peer& peer) { return {peer.case_name, peer.coordinates}; }

/// Ours with the guess of the peers at one place: all of them, and those that ratios are over.
struct Ours {
  std::vector<CandidateKey> all;
  std::optional<CandidateKey> global, fastest;  // the fastest that solves globally, and of all
};

Ours ours_beside(const Record& record, const Place& place, const std::string& guess) {
  Ours ours;
  for (const auto& [key, candidate] : record.candidates)
    if (Place(key.case_name, key.coordinates) == place && key.id.ends_with("/guess:" + guess))
      ours.all.push_back(key);
  const auto take = [&](std::optional<CandidateKey>& best, const CandidateKey& key) {
    const Measured time = measured(record, key);
    if (time.seconds && (!best || time.seconds->value < measured(record, *best).seconds->value))
      best = key;
  };
  for (const CandidateKey& key : ours.all) {
    take(ours.fastest, key);
    if (key.id.starts_with("global_")) take(ours.global, key);
  }
  return ours;
}

/// How many times as long as ours: "6.10 [5.90, 6.32]", quantities {ratio, low, high}.
Entry peer_ratio(const Record& record, const std::optional<CandidateKey>& ours,
                 const Measured& time) {
  if (!ours) return note_entry(missing_mark);
  if (!time.seconds) return note_entry(time.mark);
  return ratio_entry(speed_up(*time.seconds, *measured(record, *ours).seconds));
}

Entry peer_ratio(const Record& record, const std::optional<CandidateKey>& reference,
                 const CandidateKey& key) {
  if (reference == key) return {"1.00 reference", {"1.00", "", ""}, "reference"};
  return peer_ratio(record, reference, measured(record, key));
}

/// From the time on, what peers and ours have alike.
std::vector<Entry> row(const Record& record, const Place& place, const std::string& who,
                       const Candidate& candidate, const Measured& time, Entry over_global,
                       Entry over_fastest) {
  std::optional<double> step, position, velocity, acceleration;
  if (time.seconds)
    step = time.seconds->value / static_cast<double>(record.settings.instants) * 1e6;
  if (candidate.verification) {
    position = candidate.verification->position;
    velocity = candidate.verification->velocity;
    acceleration = candidate.verification->acceleration;
  }
  return {text_entry(std::to_string(place.second)),
          text_entry(who),
          seconds_entry(time),
          number_entry(step, 4),
          std::move(over_global),
          std::move(over_fastest),
          number_entry(time.seconds ? candidate.iterations_per_step : std::nullopt, 3),
          number_entry(position, 2),
          number_entry(velocity, 2),
          number_entry(acceleration, 2),
          text_entry(remark(candidate.status, candidate.message))};
}

std::vector<const Peer*> peers_at(const Record& record, const Place& place) {
  std::vector<const Peer*> found;
  for (const Peer& peer : record.peers)
    if (place_of(peer) == place) found.push_back(&peer);
  return found;
}

void add_rows(Table& table, const Record& record, const Place& place) {
  std::set<std::string> guesses;
  for (const Peer* peer : peers_at(record, place)) guesses.insert(peer->guess);
  for (const std::string& guess : guesses) {
    const Ours ours = ours_beside(record, place, guess);
    for (const Peer* peer : peers_at(record, place)) {
      if (peer->guess != guess) continue;
      const Measured time = measured(peer->candidate);
      table.rows.push_back(row(record, place, peer->name, peer->candidate, time,
                               peer_ratio(record, ours.global, time),
                               peer_ratio(record, ours.fastest, time)));
    }
    for (const CandidateKey& key : ours.all)
      table.rows.push_back(row(record, place, key.id, record.candidates.at(key),
                               measured(record, key), peer_ratio(record, ours.global, key),
                               peer_ratio(record, ours.fastest, key)));
  }
}

Table times_of(const Record& record, const std::string& case_name) {
  const TimeWords words = time_words(record);
  Table table{
      .name = "peers_" + case_name,
      .title = "Curves beside ours: " + case_name,
      .notes =
          {"CPU s: " + words.time +
               " ± half the range, first assembly, all steps and delivery. Times ours: the peer "
               "over our fastest global formulation, and over our fastest, with the same guess in "
               "the same run; ratio of the " +
               words.times + " [its interval]; " + inconclusive_note() + ".",
           "Iterations: of each peer's own method. Errors: largest difference from the "
           "quadruple-precision reference, in the coordinates that the peer finds."},
      .columns = {{"coordinates", {}},
                  {"solved by", {}},
                  {"CPU s", {"seconds", "half_range", "repetitions"}},
                  {"µs/step", {"microseconds"}},
                  {"times ours, global", {"ratio", "low", "high"}},
                  {"times ours, fastest", {"ratio", "low", "high"}},
                  {"iterations/step", {"iterations"}},
                  {"error q", {"error"}},
                  {"error q'", {"error"}},
                  {"error q''", {"error"}},
                  {"remark", {}}},
      .rows = {}};
  define_time(table, record);
  std::set<Place> places;
  for (const Peer& peer : record.peers)
    if (peer.case_name == case_name) places.insert(place_of(peer));
  for (const Place& place : places) add_rows(table, record, place);
  return table;
}

Table setups(const Record& record) {
  Table table{.name = "peer_setups",
              .title = "What each peer needed to be set up",
              .notes = {"Set-up s: CPU time of making the model, not in the times above. Compared: "
                        "coordinates of ours that the peer finds, too."},
              .columns = {{"case", {}},
                          {"coordinates", {}},
                          {"peer", {}},
                          {"set-up", {}},
                          {"compared", {"coordinates"}},
                          {"set-up s", {"seconds"}}},
              .rows = {}};
  std::vector<const Peer*> ordered;
  for (const Peer& peer : record.peers) ordered.push_back(&peer);
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const Peer* a, const Peer* b) { return place_of(*a) < place_of(*b); });
  for (const Peer* peer : ordered) {
    const std::string compared = peer->compared ? std::to_string(*peer->compared) : "";
    table.rows.push_back(
        {text_entry(peer->case_name), text_entry(std::to_string(peer->coordinates)),
         text_entry(peer->name),
         peer->setup.empty() ? note_entry(missing_mark) : text_entry(peer->setup),
         compared.empty() ? note_entry(missing_mark) : Entry{compared, {compared}, {}},
         number_entry(peer->candidate.setup_seconds, 2)});
  }
  return table;
}

}  // namespace

Section peers(const Record& record) {
  Section section{.title = "What peers take", .paragraphs = {}, .tables = {}};
  if (record.peers.empty()) return section;
  std::map<std::string, std::string> methods;
  std::set<std::string> cases;
  for (const Peer& peer : record.peers) {
    methods[peer.name] =
        peer.name + ": " + peer.library + " " + peer.library_version + ", " + peer.method + ".";
    cases.insert(peer.case_name);
  }
  section.paragraphs.push_back(
      "What a user would pick instead, a library or code written by hand for the case, on the same "
      "motion, in the same run and random order, held to the same verification, and started from "
      "the same guess: each extrapolates in its own coordinates (quadratic: q + q' h + q'' h²/2 of "
      "the last instant; hermite5: the quintic through q, q' and q'' of the last two; adams8: from "
      "the last q, the polynomial through q' and q'' of the last four). A ratio "
      "above 1 is a peer that takes longer.");
  for (const auto& [name, method] : methods) section.paragraphs.push_back(method);
  for (const std::string& name : cases) section.tables.push_back(times_of(record, name));
  section.tables.push_back(setups(record));
  return section;
}

}  // namespace desmo::report
