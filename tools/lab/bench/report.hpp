#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "lab/bench/bench.hpp"
#include "lab/bench/speed_summary.hpp"
#include "lab/bench/stability.hpp"
#include "lab/bench/stages.hpp"
#include "lab/experiments/plot.hpp"
#include "lab/experiments/table.hpp"

namespace quadrille::bench {

/// Returns the rows as text: shares in per cent, width errors in per cent of the true width,
/// distances in millimetres, times in milliseconds.
experiments::Table to_table(const std::vector<Row>& rows);

/// Returns the counts of surfaces as text.
experiments::Table to_table(const std::vector<StageCounts>& families);

/// Returns the counts of each cloud as text: a row for the seeds, one for the shifts, and the same
/// for all clouds together if there are several.
experiments::Table to_table(const std::vector<Stability>& clouds);

/// Returns the costs of each stage as text: times in milliseconds, instructions in millions,
/// changes in per cent.
experiments::Table to_table(const std::vector<SpeedSet>& sets);

/// Returns the rows with all their digits; missing values are null.
nlohmann::ordered_json to_json(const std::vector<Row>& rows);

/// Returns plots of recall against median time, one for each family and counted type.
std::vector<experiments::Plot> plots_of(const std::vector<Row>& rows);

/// Returns the page that says what was measured, by which contenders, and how to repeat it.
/// @param command  the command as it was typed
std::string to_markdown(const std::vector<Row>& rows, const std::vector<Contender>& contenders,
                        const std::string& command, const std::string& version);

}  // namespace quadrille::bench
