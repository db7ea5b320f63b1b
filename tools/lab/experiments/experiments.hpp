#pragma once

#include "lab/experiments/experiment.hpp"

namespace quadrille::experiments {

/// Fits under noise of 0 to 5 % of the size: 10 quadrics of random types and sizes, 20 fits each,
/// every contender (paper, figure 5 A, C, D), and time against the number of points (E).
Report run_fitting(const Settings& settings);

/// Time of one minimal solve, one thread, median over many repetitions: the closed forms against
/// decompositions of the paper's 12x10 system.
Report run_minimal(const Settings& settings);

/// λ of 2.5 million triplets with a fourth point on random quadrics: density and distribution
/// beside atan's, and the measured inverse distribution.
Report run_lambda(const Settings& settings);

/// RANSAC in neighbourhoods with 0 to 60 % outliers: bases and time until 95 % of the
/// neighbourhoods have the quadric, with 2, 3, 4 and 9 points a basis.
Report run_basis(const Settings& settings);

/// The whole detector with 2, 3, 4 and 9 points a basis over the sampling rate and over the number
/// of bases, in generated scenes: share found and time.
Report run_sampling(const Settings& settings);

/// Repeated triplets in the search, and what it costs and helps to hash them.
Report run_triplets(const Settings& settings);

/// Errors of radius and centre of the spheres that detect() finds in generated scenes, and the time
/// of the search for spheres alone beside that for all types.
Report run_spheres(const Settings& settings);

/// Bins of equal cylinders lying on each other: share found over clutter and noise.
Report run_cylinders(const Settings& settings);

/// How far the true dimensions of surfaces in generated scenes lie from the published ones, in
/// published standard deviations.
Report run_deviations(const Settings& settings);

/// Time and memory of detect() over the size of a cloud fused from many views, and what it finds.
Report run_growth(const Settings& settings);

/// The votes for λ of one basis among foreign points (paper, figure 3).
Report run_votes(const Settings& settings);

/// The surfaces of one pencil for λ from −75 to 75 (figure 4a).
Report run_pencil(const Settings& settings);

/// Fits to noisy points, drawn in sections (figure 5 B).
Report run_examples(const Settings& settings);

/// What the search finds of planes that are not taken out before it (figure 9).
Report run_planes(const Settings& settings);

/// Eight generated sequences in place of table 1's.
Report run_balls(const Settings& settings);

/// 35 generated scenes of five objects in clutter, in place of the paper's own (section 5).
Report run_objects(const Settings& settings);

/// Errors of radius and centre on a sequence of real scans, $QUADRILLE_DATA or ../shared.
/// @throws io::FileError if there are no scans, or their manifest or one of them cannot be read
Report run_sequence(const Settings& settings);

}  // namespace quadrille::experiments
