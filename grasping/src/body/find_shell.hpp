#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "base/cloud_runs.hpp"
#include "body/shell.hpp"
#include "view/depth_view.hpp"

namespace quadrille {

/// Finds the open end of a body; nullopt if it shows none. An end is open if the sensor saw past
/// what lies just below it. The rim is raised by up to 8 mm to where the points on the wall end. An
/// ellipsoid is cut where the points measured on it end, above the plane that it stands on.
/// @param up_C  unit normal of the supporting plane; zero if none is known
std::optional<Shell> find_shell(const Body& body, bool seen_inside, const CloudRuns& cloud,
                                std::span<const DepthView> views, const Eigen::Vector3d& up_C,
                                const WallThickness& wall);

}  // namespace quadrille
