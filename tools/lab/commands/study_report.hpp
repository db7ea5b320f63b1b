#pragma once

#include <string>
#include <vector>

#include "lab/study/run_study.hpp"
#include "lab/study/summary.hpp"

namespace quadrille {

/// Writes a page with the results of a study; its first clouds are processed once more for it.
/// @param settings  all settings of the study, as TOML
/// @throws io::FileError if the page cannot be written
void write_study_report(const std::string& path, const study::Study& study,
                        const std::vector<study::GroupSummary>& groups,
                        const std::string& settings);

}  // namespace quadrille
