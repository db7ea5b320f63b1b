#include "process/planner/request.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/detector/printable.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille {
namespace {

// A quaternion may miss unit norm by the rounding of single precision.
constexpr double kUnitNorm = 1e-3;

Region region_of(const grasp_request_t& request) {
  const double* q = request.region.quaternion;
  const double norm = Eigen::Vector4d(q[0], q[1], q[2], q[3]).norm();
  if (!(std::abs(norm - 1.0) < kUnitNorm)) {
    throw std::invalid_argument(
        fmt::format("region.quaternion has norm {:.3g}: must be 1, w first", norm));
  }
  const Eigen::Vector3d half = 0.5 * Eigen::Vector3d(request.region_size);
  if (!(half.array() > 0.0).all() || !half.allFinite()) {
    throw std::invalid_argument("region_size: must be finite and more than 0 along each axis");
  }
  return {bus::from_message(request.region), {-half, half}};
}

Cone cone_of(const grasp_request_t& request) {
  const Eigen::Vector3d axis(request.approach);
  if (!(axis.norm() > 0.0)) throw std::invalid_argument("approach: must not be 0");
  return {axis.normalized(), request.approach_angle};
}

Reach reach_of(const grasp_request_t& request) {
  return {Eigen::Vector3d(request.reach_base), request.reach_min, request.reach_max};
}

QuadricType type_of(const std::string& name) {
  const auto type = quadric_type_from_string(name);
  if (!type) throw std::invalid_argument(fmt::format("types: '{}' is no type", printable(name)));
  return *type;
}

}  // namespace

GraspQuery query_of(const grasp_request_t& request, const Placement& placement,
                    const std::string& cloud_frame) {
  GraspQuery query;
  query.ids.assign(request.targets.begin(), request.targets.end());
  query.tracks.assign(request.tracks.begin(), request.tracks.end());
  for (const int track : query.tracks) {
    if (track == 0) throw std::invalid_argument("tracks: 0 is no track");
  }
  for (const std::string& name : request.types) query.types.push_back(type_of(name));
  if (request.has_region) query.region = region_of(request);
  if (request.has_near) query.near_C = Eigen::Vector3d(request.near);
  query.min_size = request.min_size;
  if (request.max_size != 0.0) query.max_size = request.max_size;
  if (request.has_approach) query.approach = cone_of(request);
  if (request.has_reach) query.reach = reach_of(request);
  query.min_clearance = request.min_clearance;
  if (request.min_score != 0.0) query.min_score = request.min_score;
  if (request.per_target != 0) query.per_target = request.per_target;
  if (request.max_grasps != 0) query.max_grasps = request.max_grasps;
  if (request.deadline_ms != 0.0) query.deadline_ms = request.deadline_ms;
  query.check();
  return moved(std::move(query), pose_of_camera(request.frame, placement, cloud_frame).inverse());
}

}  // namespace quadrille
