#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "lab/bench/bench.hpp"
#include "lab/bench/stages.hpp"
#include "lab/experiments/plot.hpp"
#include "lab/experiments/table.hpp"

namespace quadrille::bench {

/// The rows as text: shares in per cent, widths in per cent of the true one, times in milliseconds.
experiments::Table to_table(const std::vector<Row>& rows);

/// Counts of surfaces as text.
experiments::Table to_table(const std::vector<StageCounts>& families);

/// The rows with all their digits; null for what has no value.
nlohmann::ordered_json to_json(const std::vector<Row>& rows);

/// Recall against median time, one plot for each family and what is counted.
std::vector<experiments::Plot> plots_of(const std::vector<Row>& rows);

/// The page that says what was measured, by whom, and how to do it again.
/// @param command  as it was typed
std::string to_markdown(const std::vector<Row>& rows, const std::vector<Contender>& contenders,
                        const std::string& command, const std::string& version);

}  // namespace quadrille::bench
