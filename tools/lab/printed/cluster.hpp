#pragma once

#include <vector>

#include "fit/normalisation.hpp"
#include "search/candidate.hpp"

namespace quadrille::printed {

/// Clusters hypotheses greedily, those with the most samples first. A hypothesis joins the first
/// cluster to whose first member its d_far or d_close is small (paper, "Hypotheses aggregation"),
/// with the limits of AgglomerateOptions. Here d_far is over the samples on either of both.
/// @param unit         coordinates in which d_close compares coefficients, best of the unit ball
/// @param samples      number of all samples
/// @param min_members  members that a cluster has at least, or it is dropped
/// @return the first member of each cluster
std::vector<Candidate> cluster(std::vector<Candidate> hypotheses, const Normalisation& unit,
                               int samples, int min_members);

}  // namespace quadrille::printed
