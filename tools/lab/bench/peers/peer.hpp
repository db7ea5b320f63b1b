#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lab/bench/oriented_cloud.hpp"
#include "lab/scoring/score.hpp"

namespace quadrille::bench {

using scoring::Found;

/// Makes a finding of the plane n·x + d = 0.
Found found_plane(const Eigen::Vector3d& n, double d, double score);
/// Makes a finding of a sphere.
Found found_sphere(const Eigen::Vector3d& centre, double radius, double score);
/// Makes a finding of a circular cylinder around the line through p along the axis.
Found found_cylinder(const Eigen::Vector3d& p, const Eigen::Vector3d& axis, double radius,
                     double score);
/// Makes a finding of a circular cone.
Found found_cone(const Eigen::Vector3d& apex, const Eigen::Vector3d& axis, double half_angle,
                 double score);

/// The functions of a peer; each chooses its settings by the family.
using Orientation = std::function<OrientationOptions(const std::string& family)>;
using Detect =
    std::function<std::vector<Found>(const OrientedCloud& cloud, const std::string& family)>;

/// The main function of a peer's program. PROGRAM CLOUD.ply FAMILY OUT.json reads a cloud and
/// writes what was found in it, with the wall and processor time from the decoded cloud to the
/// findings.
int run_peer(int argc, char** argv, const Orientation& orientation, const Detect& detect);

}  // namespace quadrille::bench
