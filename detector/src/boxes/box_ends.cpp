#include "boxes/box_ends.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/quantile.hpp"
#include "boxes/bounding_plane.hpp"
#include "boxes/sight_lines.hpp"

namespace quadrille {
namespace {

// Two outlines agree if they differ by no more than this many times their summed standard
// deviations.
constexpr double kAgreeing = 3.0;
// An end that is this near to a parallel plane rests on it [m].
constexpr double kResting = 0.008;
// Standard deviation of an end that is a face or rests on a plane, in addition to that of the
// plane's points [m].
constexpr double kPlaneStd = 0.0005;
// Neighbouring points share their noise, so that this many count as one independent measurement.
constexpr double kPointsPerMeasurement = 16.0;
// The outermost layer of a box may be rounded and noisy: its thickness [m], and at most this share
// of the side.
constexpr double kSkin = 0.008, kMaxSkinShare = 0.3;
// Lines of sight that may cross a box as strays without bounding its end: this share of the points
// on a face, and at least kMinStrays.
constexpr double kStrayShare = 0.01;
constexpr std::size_t kMinStrays = 5;

/// An end that is a face: the median position of the face's points along the axis.
BoxEnd plane_end(const BoxDraft& draft, const Face& face, int axis, int upper) {
  const Eigen::Vector3d out = draft.out_C(axis, upper);
  std::vector<double> heights;
  for (const Eigen::Vector3d& p : face.points_C) heights.push_back(out.dot(p));
  const double n = static_cast<double>(heights.size()) / kPointsPerMeasurement;
  return {median(heights), std::hypot(kPlaneStd, face.sigma / std::sqrt(std::max(1.0, n))), true};
}

/// An end from the outlines of the faces that lie along the axis. Two outlines that agree are
/// averaged; otherwise the farther one counts, since planes are often found only in part.
BoxEnd outline_end(const BoxDraft& draft, int axis, int upper) {
  std::vector<FaceEdge> edges;
  for (int i = 0; i < static_cast<int>(draft.faces.size()); ++i) {
    if (i != axis)
      edges.push_back(
          edge_of(*draft.faces[i], draft.out_C(axis, upper), draft.seen_through[i], *draft.sight));
  }
  // Nothing is seen behind a face that stands alone, so this end starts at the face itself.
  if (edges.empty()) return {-plane_end(draft, *draft.faces[0], axis, !upper).at, 0.0, false};
  const bool seen = std::any_of(edges.begin(), edges.end(), [](const auto& e) { return e.seen; });
  if (seen) std::erase_if(edges, [](const FaceEdge& e) { return !e.seen; });
  const FaceEdge& a = edges.front();
  const FaceEdge& b = edges.back();
  const double wa = 1.0 / (a.std * a.std), wb = 1.0 / (b.std * b.std);
  const double apart = std::abs(a.at - b.at);
  if (seen && apart < kAgreeing * (a.std + b.std)) {
    const double std = edges.size() > 1 ? 1.0 / std::sqrt(wa + wb) : a.std;
    return {(wa * a.at + wb * b.at) / (wa + wb), std::hypot(std, 0.5 * apart), seen};
  }
  const FaceEdge& far = a.at > b.at ? a : b;
  return {far.at, std::hypot(far.std, seen ? 0.5 * apart : 0.0), seen};
}

/// Finds the plane that stops an end from moving outward, given the end's position and the seen
/// outline.
PlaneStop stop_from(const BoxDraft& draft, const std::vector<const Detection*>& planes, double at,
                    int axis, int upper, double slack) {
  Eigen::AlignedBox3d box_A = draft.reach_A();
  box_A.min()[axis] = box_A.max()[axis] = upper ? at : -at;
  std::vector<Eigen::Vector3d> corners;
  for (int n = 0; n < 4; ++n) {
    Eigen::Vector3d corner = box_A.min();
    if (n & 1) corner[(axis + 1) % 3] = box_A.max()[(axis + 1) % 3];
    if (n & 2) corner[(axis + 2) % 3] = box_A.max()[(axis + 2) % 3];
    corners.push_back(draft.R_CA * corner);
  }
  return stop_at_plane(corners, draft.out_C(axis, upper), planes, slack);
}

/// Moves an end onto a parallel plane next to it. The outline of a face alone cannot tell the face
/// from the plane that it touches.
BoxEnd rested(const BoxDraft& draft, const std::vector<const Detection*>& planes, BoxEnd end,
              int axis, int upper) {
  const PlaneStop stop =
      stop_from(draft, planes, end.at, axis, upper, kResting + draft.max_tolerance());
  if (!stop.parallel || std::abs(stop.distance) > kResting + draft.max_tolerance()) return end;
  end.at += stop.distance;
  end.rests = true;
  end.std = std::max(kPlaneStd, 0.5 * draft.max_tolerance() / 3.0);
  return end;
}

BoxEnd find_end(const BoxDraft& draft, const std::vector<const Detection*>& planes, int axis,
                int upper) {
  if (const Face* face = draft.face_on(axis, upper)) return plane_end(draft, *face, axis, upper);
  const BoxEnd end = outline_end(draft, axis, upper);
  return end.seen ? rested(draft, planes, end, axis, upper) : end;
}

/// How far an end may move outward before the box would hide points that were seen [m].
double free_of(const BoxDraft& draft, Eigen::AlignedBox3d box_A, int axis, int upper) {
  const double skin = kSkin + draft.max_tolerance();
  for (int k = 0; k < 3; ++k) {
    const double off = k == axis ? 0.0 : std::min(skin, kMaxSkinShare * box_A.sizes()[k]);
    box_A.min()[k] += off;
    box_A.max()[k] -= off;
  }
  // Points within the noise of the end may belong to the end itself, so the added part begins
  // beyond.
  (upper ? box_A.max() : box_A.min())[axis] += (upper ? 1.0 : -1.0) * skin;
  Eigen::AlignedBox3d reach_A = box_A;
  (upper ? reach_A.max() : reach_A.min())[axis] += (upper ? 1.0 : -1.0) * kMaxSide;
  std::size_t strays = kMinStrays;
  for (const Face* face : draft.faces) {
    const double share = kStrayShare * static_cast<double>(face->points_C.size());
    strays = std::max(strays, static_cast<std::size_t>(share));
  }
  const auto points = draft.sight->points_towards(draft.corners_C(reach_A), 0.0);
  return skin +
         free_of_sight(box_A, draft.X_CA(), axis, upper ? 1 : -1, points, *draft.sight, strays);
}

void bound(const BoxDraft& draft, const std::vector<const Detection*>& planes,
           const Eigen::AlignedBox3d& box_A, int axis, int upper, BoxEnd* end) {
  const PlaneStop stop = stop_from(draft, planes, end->at, axis, upper, kResting);
  const double free = free_of(draft, box_A, axis, upper), side = box_A.sizes()[axis];
  end->may_reach = std::max(0.0, std::min({stop.distance, free, kMaxSide - side}));
  // The unseen end rests on the plane beyond it unless lines of sight pass between the two.
  end->rests = stop.parallel && stop.distance <= free + kSkin + draft.max_tolerance();
  // If any part of a side was seen, assume that the hidden rest is shorter than the seen part.
  end->likely = end->rests ? end->may_reach : side > 0.0 ? 0.0 : 0.5 * end->may_reach;
}

}  // namespace

BoxEnds find_ends(const BoxDraft& draft, const std::vector<const Detection*>& planes) {
  BoxEnds ends;
  for (int axis = 0; axis < 3; ++axis) {
    for (int upper = 0; upper < 2; ++upper) {
      ends[axis][upper] = find_end(draft, planes, axis, upper);
    }
  }
  return ends;
}

void bound_open_ends(const BoxDraft& draft, const std::vector<const Detection*>& planes,
                     BoxEnds* ends) {
  const Eigen::AlignedBox3d box_A = seen_part(*ends);
  for (int axis = 0; axis < 3; ++axis) {
    for (int upper = 0; upper < 2; ++upper) {
      BoxEnd& end = (*ends)[axis][upper];
      if (!end.seen) bound(draft, planes, box_A, axis, upper, &end);
    }
  }
}

Eigen::AlignedBox3d seen_part(const BoxEnds& ends) {
  Eigen::AlignedBox3d box;
  for (int axis = 0; axis < 3; ++axis) {
    box.min()[axis] = -ends[axis][0].at;
    box.max()[axis] = ends[axis][1].at;
  }
  return box;
}

}  // namespace quadrille
