// The paper's seven analyses and the formulations that stand for them: the one table of names.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "report/read/record.h"

namespace desmo::report {

/// MA27, which cannot be redistributed: only a user who has it can record it.
inline constexpr std::string_view papers_own = "ma27";
/// Sparse solvers that stand in the paper's columns of MA27, in the order of tables.
inline constexpr std::array<std::string_view, 4> sparse_families{papers_own, "cholmod", "umfpack",
                                                                 "klu"};
/// All dense solvers, in the order of tables. The report sees nothing of Backend::dense.
inline constexpr std::array<std::string_view, 2> dense_families{"lapack", "eigen"};

/// The formulation that everything is compared with.
inline constexpr std::string_view usual_reference = "global_automatic_klu";

struct PaperVariant {
  std::string_view paper_name;  ///< a family's name replaces its "MA27"
  std::string_view case_name;
  std::string_view id;  ///< "<sparse>" in it gives way to the family
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
/// Columns of table 2: the variants after their reference.
inline constexpr std::span<const PaperVariant> topological = std::span(paper_variants).subspan(3);

/// The size at which the paper says that the four-bar's times begin to show.
inline constexpr std::int64_t published_four_bar = 1002;

/// Returns whether an id says that a formulation has other settings than the paper's.
inline bool has_settings(std::string_view id) { return id.find('/') != std::string_view::npos; }

/// Returns the id of the formulation, without settings.
inline std::string_view without_settings(std::string_view id) { return id.substr(0, id.find('/')); }

/// Returns whether a formulation may be a reference: global_automatic_<sparse> with the paper's
/// algorithm, whatever the settings of its iteration.
bool is_reference(const Configuration& configuration);

/// Returns how a formulation solves linear systems: "sparse" or "dense", or "generated" code.
std::string algebra_kind(std::string_view id);

/// Returns the value of a setting in an id: "adams8" of guess in global_automatic_klu/guess:adams8;
/// empty where the id does not name it.
std::string_view setting(std::string_view id, std::string_view name);

/// Returns the id without a setting.
std::string without_setting(std::string id, const std::string& name);

/// Tells whether a formulation stands next to a peer, with no other setting than its guess.
bool is_beside(const Peer& peer, std::string_view id);
bool is_beside_peers(const Record& record, std::string_view id);

/// Returns a variant's name in a family: of TS-TPA_MA27 and klu TS-TPA_klu.
std::string family_name(const PaperVariant& variant, std::string_view family);

/// Returns the candidate that stands for the variant in a family.
CandidateKey family_key(const PaperVariant& variant, std::int64_t coordinates,
                        std::string_view family);

}  // namespace desmo::report
