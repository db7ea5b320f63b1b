#pragma once

#include <string>
#include <vector>

#include "lab/study/run_study.hpp"
#include "lab/study/summary.hpp"

namespace quadrille {

/// Writes a page with the shares of a study, and its first clouds worked on once more.
/// @param settings  all of the study, as TOML
/// @throws io::FileError if it cannot be written
void write_study_report(const std::string& path, const study::Study& study,
                        const std::vector<study::GroupSummary>& groups,
                        const std::string& settings);

}  // namespace quadrille
