// Files that the build puts into the program, so that it needs no path at run time.
#pragma once

#include <string_view>

namespace desmo::report::embedded {

extern const std::string_view table1_cpu_seconds;          ///< results/paper/table1_cpu_seconds.csv
extern const std::string_view table2_speedup;              ///< results/paper/table2_speedup.csv
extern const std::string_view table2_improvement_percent;  ///< .../table2_improvement_percent.csv
extern const std::string_view figure5;                     ///< report/figures/figure5.template.json
extern const std::string_view figure6;                     ///< report/figures/figure6.template.json
extern const std::string_view growth;                      ///< .../growth.template.json
extern const std::string_view work_precision;              ///< .../work_precision.template.json
extern const std::string_view texts;                       ///< report/text/texts.txt
extern const std::string_view page_style;                  ///< report/formats/page.css

}  // namespace desmo::report::embedded
