#pragma once

#include "lab/experiments/experiment.hpp"

namespace quadrille::experiments {

/// Fits under noise of 0 to 5 % of the size: 10 quadrics of random types and sizes, 20 fits each,
/// with every contender (paper, figure 5 A, C, D), and time against the number of points (E).
Report run_fitting(const Settings& settings);

/// Time of one minimal solve on one thread, median over many repetitions: the closed forms against
/// decompositions of the paper's 12x10 system.
Report run_minimal(const Settings& settings);

/// λ of 2.5 million triplets with a fourth point on random quadrics: its density and distribution
/// beside those of atan, and the measured inverse distribution.
Report run_lambda(const Settings& settings);

/// RANSAC in neighbourhoods with 0 to 60 % outliers: bases and time until the quadric is found in
/// 95 % of the neighbourhoods, with 2, 3, 4 and 9 points per basis.
Report run_basis(const Settings& settings);

/// The whole detector with 2, 3, 4 and 9 points per basis over the sampling rate and over the
/// number of bases, in generated scenes: share found and time.
Report run_sampling(const Settings& settings);

/// How often the search draws the same triplet again, and what hashing triplets costs and saves.
Report run_triplets(const Settings& settings);

/// Errors of radius and centre of the spheres that detect() finds in generated scenes, and the time
/// of the search for spheres alone beside that for all types.
Report run_spheres(const Settings& settings);

/// Bins of equal cylinders lying on each other: share found over clutter and noise.
Report run_cylinders(const Settings& settings);

/// How far the true dimensions of surfaces in generated scenes lie from the published ones, in
/// published standard deviations.
Report run_deviations(const Settings& settings);

/// Time, memory and findings of detect() over the size of a cloud fused from many views.
Report run_growth(const Settings& settings);

/// The votes for λ of one basis among points of other surfaces (paper, figure 3).
Report run_votes(const Settings& settings);

/// The surfaces of one pencil for λ from −75 to 75 (figure 4a).
Report run_pencil(const Settings& settings);

/// Fits to noisy points, drawn in sections (figure 5 B).
Report run_examples(const Settings& settings);

/// Findings of the search on planes that were not removed before it (figure 9).
Report run_planes(const Settings& settings);

/// Eight generated sequences that stand in for those of table 1.
Report run_balls(const Settings& settings);

/// 35 generated scenes of five objects in clutter that stand in for the paper's own (section 5).
Report run_objects(const Settings& settings);

/// Errors of radius and centre on a sequence of real scans from $QUADRILLE_DATA or ../shared.
/// @throws io::FileError if there are no scans, or their manifest or one of them cannot be read
Report run_sequence(const Settings& settings);

}  // namespace quadrille::experiments
