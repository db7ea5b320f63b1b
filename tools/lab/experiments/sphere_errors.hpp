#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lab/experiments/experiment.hpp"
#include "lab/scoring/frame.hpp"
#include "quadrille/detector/detection.hpp"

namespace quadrille::experiments {

/// A sphere that is known to be there.
struct KnownSphere {
  Eigen::Vector3d centre_C;
  double radius;
};

/// The errors of a found sphere, relative to the true radius; zero if it was not found.
struct SphereError {
  bool found = false;
  /// Found radius divided by the true one, minus 1.
  double radius = 0.0;
  /// Distance between the centres divided by the true radius.
  double centre = 0.0;
};

/// Returns the errors of the sphere (or ellipsoid, by its mean semi-axis) whose centre is nearest
/// to the true one, if it lies within one radius.
SphereError match(const DetectionResult& result, const KnownSphere& truth);

/// Number of detected spheres that are none, or a second one of the same surface.
int false_spheres(const scoring::Frame& frame, DetectionResult result);

/// Reports quantiles and distributions of the errors, by group.
Report report_errors(const std::map<std::string, std::vector<SphereError>>& groups);

}  // namespace quadrille::experiments
