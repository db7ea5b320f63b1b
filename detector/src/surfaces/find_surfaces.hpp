#pragma once

#include <functional>
#include <vector>

#include "base/mask.hpp"
#include "base/stage_clock.hpp"
#include "quadrille/detector/options.hpp"
#include "samples/sample_tree.hpp"
#include "search/hypotheses.hpp"
#include "surfaces/aggregate.hpp"

namespace quadrille {

/// Searches one level, and returns candidates whose regions refer to the finest samples.
/// @param open     per sample of the level, zero to leave it out
/// @param propose  empty for the way that the options select
std::vector<Candidate> find_candidates(const SampleTree& tree, int level, Mask open,
                                       const DetectorOptions& options, Propose propose = {});

/// A way to search one level, such as find_candidates().
using FindCandidates = std::function<std::vector<Candidate>(const SampleTree&, int level, Mask open,
                                                            const DetectorOptions&)>;

/// Searches for surfaces and selects among the candidates, from coarse to fine, so that the finer
/// levels need not search what a coarse level found clearly.
/// @param tree      must outlive the result
/// @param clock     receives the stages "search" and "aggregate"
/// @param observer  called for each candidate that is tried; may be empty
/// @param find      empty for find_candidates()
Aggregation find_surfaces(const SampleTree& tree, SceneContext context,
                          const DetectorOptions& options, StageClock& clock,
                          TrialObserver observer = {}, const FindCandidates& find = {});

}  // namespace quadrille
