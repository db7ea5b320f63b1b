#include "boxes/missing_face.hpp"

#include <algorithm>
#include <array>

#include "boxes/face_edge.hpp"
#include "boxes/find_faces.hpp"
#include "boxes/grouping.hpp"

namespace quadrille {
namespace {

// A missing face is at most this many times as noisy as the known ones.
constexpr double kMaxNoise = 2.0;

/// Range of the known faces along a direction [m].
std::pair<double, double> reach_of(const std::vector<const Face*>& faces,
                                   const Eigen::Vector3d& u_C) {
  std::pair<double, double> reach = faces.front()->reach(u_C);
  for (const Face* face : faces) {
    const auto [low, high] = face->reach(u_C);
    reach = {std::min(reach.first, low), std::max(reach.second, high)};
  }
  return reach;
}

/// Position at which the known face with the most points ends in a direction.
double end_of(const std::vector<const Face*>& faces, const Eigen::Vector3d& out_C,
              const FacePatch& patch, const DirectionIndex& sight) {
  const Face* known = faces.front();
  for (const Face* face : faces) {
    if (face->points_C.size() > known->points_C.size()) known = face;
  }
  const Eigen::Vector3d step = patch.half.norm() * known->n_C.cross(out_C);
  const Eigen::Vector3d& middle = patch.X_CP.translation();
  const std::array<Eigen::Vector3d, 3> places = {known->middle_C, middle - step, middle + step};
  const auto around = look_through(*known, sight.points_towards(places, kAround), sight);
  return edge_of(*known, out_C, around, sight).at;
}

/// Noise along the line of sight [m].
double sensor_noise(const Face& face) { return face.sigma / face.cosine; }

bool belongs(const Face& missing, const std::vector<const Face*>& faces) {
  return std::all_of(faces.begin(), faces.end(), [&](const Face* face) {
    return at_right_angles(missing, *face) && share_edge(missing, *face) &&
           sensor_noise(missing) < kMaxNoise * sensor_noise(*face);
  });
}

/// The missing face on one side, if it is there.
std::optional<Face> face_on(const Eigen::Vector3d& out_C, const std::vector<const Face*>& faces,
                            const Eigen::Matrix3d& R_CA, int axis, const DirectionIndex& sight) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  Eigen::Vector3d middle_A;
  Eigen::Vector2d half;
  const auto set = [&](int k, double* half_size) {
    auto [low, high] = reach_of(faces, R_CA.col(k));
    // The depth behind a single face is not known; it is taken to be at most the face's length.
    if (faces.size() == 1 && k == 0) low -= 2.0 * faces.front()->radius;
    middle_A[k] = 0.5 * (low + high);
    *half_size = 0.5 * (high - low);
  };
  set(u, &half.x());
  set(v, &half.y());
  const double sign = out_C.dot(R_CA.col(axis)) > 0.0 ? 1.0 : -1.0;
  FacePatch patch;
  patch.X_CP.linear() << sign * R_CA.col(u), R_CA.col(v), out_C;
  patch.half = half;
  middle_A[axis] = sign * reach_of(faces, out_C).second;
  patch.X_CP.translation() = R_CA * middle_A;
  const double cosine = out_C.dot((sight.eye() - patch.X_CP.translation()).normalized());
  if (cosine < kMinCosine) return std::nullopt;
  middle_A[axis] = sign * end_of(faces, out_C, patch, sight);
  patch.X_CP.translation() = R_CA * middle_A;
  std::optional<Face> face = face_at(patch, cosine * sensor_noise(*faces.front()), sight);
  if (!face || !belongs(*face, faces)) return std::nullopt;
  return face;
}

}  // namespace

std::optional<Face> find_missing_face(const std::vector<const Face*>& faces,
                                      const Eigen::Matrix3d& R_CA, const DirectionIndex& sight) {
  std::optional<Face> best;
  if (!sight.single()) return best;
  for (int axis = static_cast<int>(faces.size()); axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      std::optional<Face> face = face_on(sign * R_CA.col(axis), faces, R_CA, axis, sight);
      if (face && (!best || face->points_C.size() > best->points_C.size())) best = std::move(face);
    }
  }
  return best;
}

}  // namespace quadrille
