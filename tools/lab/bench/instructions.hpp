#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "quadrille/detector/point_cloud.hpp"

namespace quadrille::bench {

/// Parts of a counted run that are no stages of the detector.
inline constexpr std::string_view kReading = "reading", kMakingSamples = "making samples",
                                  kPassOverPoints = "pass over points",
                                  kPassOverSamples = "pass over samples";

/// Numbers of instructions by part, in the order in which the parts first ended.
using Instructions = std::vector<std::pair<std::string, std::uint64_t>>;

/// Returns the instructions of a part; 0 if there is no such part.
std::uint64_t instructions_of(const Instructions& counts, std::string_view part);

/// Says why instructions cannot be counted here; empty if they can.
/// @param programs  folder of the program that is counted
std::string why_not_counted(const std::string& programs);

/// Counts the instructions of a detection with one thread by stage, and of one pass over the points
/// and over the samples. Callgrind runs them, which takes some seconds.
/// @param config  path of the detector's settings; empty for the defaults
/// @throws std::runtime_error if that fails
Instructions count_instructions(const std::string& programs, const PointCloud& cloud,
                                const std::string& config);

/// Reads what callgrind wrote.
/// @param names     the name of each part that ended, one a line
/// @param profiles  a profile for each of them, and for what came after the last
/// @throws std::runtime_error if they do not fit each other
Instructions parse_counts(std::string_view names, std::string_view profiles);

}  // namespace quadrille::bench
