#pragma once

#include "lab/experiments/experiment.hpp"

namespace quadrille::experiments {

/// An experiment; all_experiments() says what each of them measures.
using Run = Report(const Settings& settings);

Run run_fitting, run_minimal, run_lambda, run_basis, run_sampling, run_triplets, run_printed,
    run_spheres, run_cylinders, run_deviations, run_growth, run_votes, run_pencil, run_examples,
    run_planes, run_balls, run_objects;

/// Reads real scans from $QUADRILLE_DATA or ../shared.
/// @throws io::FileError if there are no scans, or their manifest or one of them cannot be read
Run run_sequence;

}  // namespace quadrille::experiments
