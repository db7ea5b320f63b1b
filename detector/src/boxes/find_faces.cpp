#include "boxes/find_faces.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "boxes/bend.hpp"
#include "boxes/face_finder.hpp"

namespace quadrille {
namespace {

// A face is fitted at most so often to the points that its last fit explains, as long as its area
// grows by this factor.
constexpr int kMaxRefits = 6;
constexpr double kMinGrowth = 1.1;
// A face is at most this many times as noisy as the samples by which it was found. One that grows
// is no noisier than them: if it grows onto a neighbour, the step between the two passes for noise,
// and the face swallows whatever lies near.
constexpr double kMaxNoise = 2.0;
// So many points in and around a patch suffice to tell how far it grows and whether it bends.
constexpr std::size_t kDraftPoints = 1500;

FacePatch patch_of(const Detection& plane) {
  FacePatch patch{plane.X_CQ, 0.5 * plane.extent_Q.sizes().head<2>()};
  Eigen::Vector3d middle_Q = plane.extent_Q.center();
  middle_Q.z() = 0.0;
  patch.X_CP.translation() = plane.X_CQ * middle_Q;
  if (outward_normal(plane).dot(patch.X_CP.linear().col(2)) < 0.0) {
    patch.X_CP.linear().col(1) *= -1.0;
    patch.X_CP.linear().col(2) *= -1.0;
  }
  return patch;
}

/// Area that the points stand for, however far they are thinned [m²].
double area_of(const Face& face) {
  return static_cast<double>(face.points_C.size()) * face.pitch * face.pitch / face.cosine;
}

/// A face after it was fitted to its own points again and again, as long as it grows; nullopt if
/// there is none.
std::optional<MeasuredFace> grown(const MeasuredFace& measured, const Eigen::Matrix3d& R_CL,
                                  const FaceFinder& finder) {
  std::optional<MeasuredFace> best;
  for (int round = 0; round < kMaxRefits; ++round) {
    std::optional<MeasuredFace> next = finder.refitted(best ? *best : measured, R_CL);
    if (!next) break;
    if (best && area_of(next->face) < kMinGrowth * area_of(best->face)) break;
    best = std::move(next);
  }
  return best;
}

/// The largest face in a patch, with the plane that is fitted to it.
/// @param sigma   noise of the points along the patch's normal [m]
/// @param margin  how far beside the patch the face may reach [m]
std::optional<MeasuredFace> measured_face_at(const FacePatch& patch, double sigma, double margin,
                                             const DirectionIndex& sight) {
  const FaceFinder finder(sight, {.max_sigma = kMaxNoise * sigma, .margin = margin});
  const std::vector<MeasuredFace> found = finder.faces_in(patch, sigma);
  if (found.empty()) return std::nullopt;
  return finder.refitted(found.front(), patch.X_CP.linear());
}

/// A measured face with how far it bulges.
Face bent(MeasuredFace measured, const Bend& bend) {
  measured.face.bulge = bend.bulge;
  measured.face.bulge_std = bend.bulge_std;
  return std::move(measured.face);
}
Face bent(MeasuredFace measured) {
  const Bend bend = bend_of(measured.face, measured.measured_C);
  return bent(std::move(measured), bend);
}

/// The same; nullopt if the face bends more than worn boxes do.
std::optional<Face> unbent(MeasuredFace measured) {
  const Bend bend = bend_of(measured.face, measured.measured_C);
  if (bend.turn > kMaxTurn) return std::nullopt;
  return bent(std::move(measured), bend);
}

/// The face that grows from a patch; nullopt if there is none, or if it bends.
std::optional<Face> flat_face(const FacePatch& patch, double sigma, const DirectionIndex& sight,
                              std::size_t max_points) {
  const FaceFinder finder(sight, {.max_sigma = sigma, .max_points = max_points});
  const std::vector<MeasuredFace> found = finder.faces_in(patch, sigma);
  if (found.empty()) return std::nullopt;
  std::optional<MeasuredFace> measured = grown(found.front(), patch.X_CP.linear(), finder);
  if (!measured) return std::nullopt;
  std::optional<Face> face = unbent(std::move(*measured));
  if (face) face->is_patch = true;
  return face;
}

}  // namespace

std::optional<Face> face_at(const FacePatch& patch, double sigma, const DirectionIndex& sight) {
  std::optional<MeasuredFace> measured = measured_face_at(patch, sigma, kMaxTolerance, sight);
  if (!measured) return std::nullopt;
  return bent(*std::move(measured));
}

std::optional<Face> unbent_face_at(const FlatPatch& flat, const DirectionIndex& sight) {
  std::optional<MeasuredFace> measured =
      measured_face_at(flat.patch, flat.sigma, flat.margin, sight);
  return measured ? unbent(std::move(*measured)) : std::nullopt;
}

std::optional<Face> draft_face(const FlatPatch& flat, const DirectionIndex& sight) {
  return flat_face(flat.patch, flat.sigma, sight, kDraftPoints);
}

std::optional<Face> finished_face(const Face& draft, const DirectionIndex& sight) {
  Eigen::Matrix3d R_CL;
  R_CL << draft.n_C.unitOrthogonal(), Eigen::Vector3d::Zero(), draft.n_C;
  return flat_face(patch_around(draft.points_C, R_CL), draft.sigma, sight, kMaxPoints);
}

std::vector<Face> faces_of(const Detection& plane, const DirectionIndex& sight) {
  const FacePatch patch = patch_of(plane);
  const FaceFinder finder(sight);
  std::vector<MeasuredFace> found = finder.faces_in(patch);
  std::vector<Face> faces;
  for (MeasuredFace& measured : found) {
    // If a plane has several faces, each has a plane of its own, and the common plane is only
    // their mean.
    auto own = found.size() > 1 ? finder.refitted(measured, patch.X_CP.linear()) : std::nullopt;
    if (own) measured = std::move(*own);
    faces.push_back(bent(std::move(measured)));
    faces.back().id = plane.id;
    faces.back().score = plane.score;
  }
  return faces;
}

}  // namespace quadrille
