// The paper's seven analyses and the ids of the formulations that stand for them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "report/read/record.h"

namespace desmo::report {

/// MA27, the paper's solver. It cannot be redistributed: only a user who has it can record it.
inline constexpr std::string_view papers_own = "ma27";
/// Families: sparse solvers that stand in the paper's columns of MA27, in the order of tables.
inline constexpr std::array<std::string_view, 4> sparse_families{papers_own, "cholmod", "umfpack",
                                                                 "klu"};
/// All dense solvers, in the order of tables. They are named here since a record does not tell
/// which solvers are dense.
inline constexpr std::array<std::string_view, 2> dense_families{"lapack", "eigen"};

/// The usual reference: speed-ups are relative to this formulation unless their table names another
/// reference. Others are truck_global, the fastest formulation that is_reference() allows, and the
/// same analysis on one thread.
inline constexpr std::string_view usual_reference = "global_automatic_klu";

/// One of the paper's analyses.
struct PaperVariant {
  std::string_view paper_name;  ///< name in the paper; with another family that replaces "MA27"
  std::string_view case_name;
  std::string_view id;  ///< id of the formulation; the family replaces "<sparse>"
};

/// The paper's analyses in the order of the columns of its table 1.
inline constexpr std::array<PaperVariant, 7> paper_variants{
    {{"FBL-G_MA27", "four_bar", "global_automatic_<sparse>"},
     {"FBL-TP", "four_bar", "group_symbolic_inlined"},
     {"TS-G_MA27", "truck_suspension", "global_automatic_<sparse>"},
     {"TS-TPA_MA27", "truck_suspension", "group_automatic_<sparse>"},
     {"TS-TPA_LAP", "truck_suspension", "group_automatic_lapack"},
     {"TS-TPS_MA27", "truck_suspension", "group_symbolic_<sparse>"},
     {"TS-TPS_LAP", "truck_suspension", "group_symbolic_lapack"}}};

inline constexpr const PaperVariant& truck_global = paper_variants[2];  ///< reference of table 2
inline constexpr std::string_view truck_case = truck_global.case_name;
/// The variants in the columns of table 2, which stand after their reference in paper_variants.
inline constexpr std::span<const PaperVariant> topological = std::span(paper_variants).subspan(3);

/// Number of coordinates from which on, as the paper says, the four-bar's times can be seen.
inline constexpr std::int64_t published_four_bar = 1002;

/// Returns whether an id has settings.
inline bool has_settings(std::string_view id) { return id.find('/') != std::string_view::npos; }

/// Returns the id of the formulation, without settings.
inline std::string_view without_settings(std::string_view id) { return id.substr(0, id.find('/')); }

/// Returns whether a formulation may be a reference: global_automatic_<sparse> with
/// has_papers_algorithm(), whatever the settings of its iteration.
bool is_reference(const Configuration& configuration);

/// Returns how a formulation solves linear systems: "sparse" or "dense", or "generated" code.
std::string algebra_kind(std::string_view id);

/// Returns the value of a setting in an id, such as "adams8" of "guess" in
/// global_automatic_klu/guess:adams8; empty where the id does not have the setting.
std::string_view setting(std::string_view id, std::string_view name);

/// Returns the id without a setting.
std::string without_setting(std::string id, const std::string& name);

/// Tell whether the table of peers shows a formulation next to a peer, or next to any peer of a
/// record: whether the only setting in its id is the peer's guess.
bool is_beside(const Peer& peer, std::string_view id);
bool is_beside_peers(const Record& record, std::string_view id);

/// Returns a variant's name in a family: TS-TPA_klu for TS-TPA_MA27 and klu.
std::string family_name(const PaperVariant& variant, std::string_view family);

/// Returns the candidate that stands for the variant in a family.
CandidateKey family_key(const PaperVariant& variant, std::int64_t coordinates,
                        std::string_view family);

}  // namespace desmo::report
