#pragma once

#include <vector>

#include "base/stage_clock.hpp"
#include "quadrille/detector/options.hpp"
#include "samples/sample_tree.hpp"
#include "surfaces/aggregate.hpp"

namespace quadrille {

/// What the search finds on one level, with regions in terms of the finest samples.
/// @param open  per sample of the level, zero to leave it out
std::vector<Candidate> find_candidates(const SampleTree& tree, int level, std::vector<char> open,
                                       const DetectorOptions& options);

/// Searches for surfaces and chooses among what is found, from coarse to fine: what a coarse level
/// finds clearly, the finer ones need not search.
/// @param tree   must outlive the result
/// @param clock     ends the stages "search" and "aggregate"
/// @param observer  told of each candidate that is tried; may be empty
Aggregation find_surfaces(const SampleTree& tree, SceneContext context,
                          const DetectorOptions& options, StageClock& clock,
                          TrialObserver observer = {});

}  // namespace quadrille
