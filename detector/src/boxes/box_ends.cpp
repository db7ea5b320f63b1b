#include "boxes/box_ends.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/quantile.hpp"
#include "boxes/bounding_plane.hpp"
#include "boxes/rounded_box_fit.hpp"
#include "boxes/sight_lines.hpp"

namespace quadrille {
namespace {

// Standard deviation of an end that is a face or rests on a plane, in addition to that of the
// plane's points [m].
constexpr double kPlaneStd = 0.0005;
// The outlines of two faces tell the same end if they are no farther apart than this many standard
// deviations, beside the rounding.
constexpr double kMaxApart = 3.0;
// A sensor mixes pixels if points float in this share of the rows that tell, of so many rows at
// least. In simulated scenes it is 1 for most outlines of sensors that mix, and 0 for most others.
constexpr double kMinMixed = 0.7;
constexpr int kMinRows = 8;

/// An end that is a face: the median position of the face's points along the axis.
BoxEnd plane_end(const BoxDraft& draft, const Face& face, int axis, int upper) {
  const Eigen::Vector3d out = draft.out_C(axis, upper);
  std::vector<double> heights;
  for (const Eigen::Vector3d& p : face.points_C) heights.push_back(out.dot(p));
  const double noise = face.sigma / std::sqrt(std::max(1.0, face.measurements()));
  return {median(heights), std::hypot(kPlaneStd, noise), true};
}

/// The edges of each face in the directions of all ends, at 2 · axis + upper.
using FaceEdges = std::vector<std::array<FaceEdge, 6>>;

/// True if the sensor mixes pixels at outlines: in most rows that tell points float between a face
/// and what lies behind.
bool are_mixed(const FaceEdges& edges) {
  int rows = 0, mixed = 0;
  for (const auto& of_face : edges) {
    for (const FaceEdge& edge : of_face) {
      rows += edge.mixed.rows;
      mixed += edge.mixed.mixed;
    }
  }
  return rows >= kMinRows && mixed >= kMinMixed * rows;
}

/// Finds these edges. Where the sensor mixed pixels, the edge lies beyond the rows of the face. The
/// outlines of all faces tell together whether the sensor mixes, since a thing behind one of them
/// may look as if it did.
FaceEdges edges_of(const BoxDraft& draft) {
  FaceEdges edges(draft.faces.size());
  for (int i = 0; i < static_cast<int>(edges.size()); ++i) {
    for (int k = 0; k < 6; ++k) {
      if (k / 2 == i || draft.face_on(k / 2, k % 2)) continue;
      edges[i][k] =
          edge_of(*draft.faces[i], draft.out_C(k / 2, k % 2), draft.seen_through[i], *draft.sight);
    }
  }
  if (!are_mixed(edges)) return edges;
  for (auto& of_face : edges) {
    for (FaceEdge& edge : of_face) {
      edge.at += edge.mixed.reach;
      edge.std = std::hypot(edge.std, edge.mixed.std);
    }
  }
  return edges;
}

/// The outlines that tell where an end is: those of the faces that lie along the axis. A face that
/// bulges or is hidden in part may end early, so of two outlines that are far apart the farther one
/// is kept. Otherwise those that were seen are kept, if there are any.
std::vector<Outline> outlines_of(const BoxDraft& draft, const FaceEdges& edges, int axis,
                                 int upper) {
  const Eigen::Vector3d out_C = draft.out_C(axis, upper);
  std::vector<Outline> outlines;
  for (int i = 0; i < static_cast<int>(draft.faces.size()); ++i) {
    if (i == axis) continue;
    outlines.push_back({draft.faces[i], axis, upper, out_C, edges[i][2 * axis + upper]});
  }
  if (outlines.size() < 2) return outlines;
  const FaceEdge &a = outlines.front().edge, &b = outlines.back().edge;
  const double apart = kMaxApart * std::hypot(a.std, b.std) + kRounding;
  if (std::abs(a.at - b.at) > apart) {
    outlines.erase(a.at < b.at ? outlines.begin() : outlines.end() - 1);
  } else if (a.seen != b.seen) {
    outlines.erase(b.seen ? outlines.begin() : outlines.end() - 1);
  }
  return outlines;
}

/// An end from its outlines. Two outlines that were seen are averaged; of two that were not, the
/// farther one counts.
BoxEnd outline_end(const BoxDraft& draft, const std::vector<Outline>& outlines, int axis,
                   int upper) {
  // Nothing is seen behind a face that stands alone, so this end starts at the face itself.
  if (outlines.empty()) return {-plane_end(draft, *draft.faces[0], axis, !upper).at, 0.0, false};
  const FaceEdge &a = outlines.front().edge, &b = outlines.back().edge;
  if (!a.seen) return {std::max(a.at, b.at), a.at > b.at ? a.std : b.std, false};
  if (outlines.size() == 1) return {a.at, a.std, true};
  const double wa = 1.0 / (a.std * a.std), wb = 1.0 / (b.std * b.std);
  const double std = std::hypot(1.0 / std::sqrt(wa + wb), 0.5 * (a.at - b.at));
  return {(wa * a.at + wb * b.at) / (wa + wb), std, true};
}

/// Finds the plane that stops an end from moving outward, given the end's position and the seen
/// outline.
PlaneStop stop_from(const BoxDraft& draft, const std::vector<const Detection*>& planes, double at,
                    int axis, int upper, double slack) {
  Eigen::AlignedBox3d box_A = draft.reach_A;
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

/// Finds an end, and adds the outlines that show it to a list.
BoxEnd find_end(const BoxDraft& draft, const std::vector<const Detection*>& planes,
                const FaceEdges& edges, int axis, int upper, std::vector<Outline>* shown) {
  if (const Face* face = draft.face_on(axis, upper)) return plane_end(draft, *face, axis, upper);
  const std::vector<Outline> outlines = outlines_of(draft, edges, axis, upper);
  const BoxEnd end = outline_end(draft, outlines, axis, upper);
  if (!end.seen) return end;
  shown->insert(shown->end(), outlines.begin(), outlines.end());
  return rested(draft, planes, end, axis, upper, draft.skin());
}

/// How far an end may move outward before the box would hide points that were seen [m].
double free_of(const BoxDraft& draft, const Eigen::AlignedBox3d& whole_A, int axis, int upper) {
  const double skin = draft.skin();
  Eigen::AlignedBox3d box_A = draft.core_A(whole_A);
  box_A.min()[axis] = whole_A.min()[axis];
  box_A.max()[axis] = whole_A.max()[axis];
  // Points within the noise of the end may belong to the end itself, so the added part begins
  // beyond.
  (upper ? box_A.max() : box_A.min())[axis] += (upper ? 1.0 : -1.0) * skin;
  Eigen::AlignedBox3d reach_A = box_A;
  (upper ? reach_A.max() : reach_A.min())[axis] += (upper ? 1.0 : -1.0) * kMaxSide;
  const auto points = draft.sight->points_towards(draft.corners_C(reach_A), 0.0);
  return skin + free_of_sight(box_A, draft.X_CA(), axis, upper ? 1 : -1, points, *draft.sight,
                              draft.max_strays());
}

BoxEnd bounded(const BoxDraft& draft, const std::vector<const Detection*>& planes,
               const Eigen::AlignedBox3d& box_A, int axis, int upper, BoxEnd end) {
  const PlaneStop stop = stop_from(draft, planes, end.at, axis, upper, kRounding);
  const double free = free_of(draft, box_A, axis, upper), side = box_A.sizes()[axis];
  const double most = std::max(0.0, std::min({stop.distance, free, kMaxSide - side}));
  if (end.seen) {
    end.may_reach = std::min(end.may_reach, most);
    return end;
  }
  end.may_reach = most;
  // The unseen end rests on the plane beyond it unless lines of sight pass between the two.
  end.rests = stop.parallel && stop.distance <= free + draft.skin();
  // If any part of a side was seen, assume that the hidden rest is shorter than the seen part.
  end.likely = end.rests ? end.may_reach : side > 0.0 ? 0.0 : 0.5 * end.may_reach;
  return end;
}

}  // namespace

BoxEnd rested(const BoxDraft& draft, const std::vector<const Detection*>& planes, BoxEnd end,
              int axis, int upper, double within) {
  const PlaneStop stop = stop_from(draft, planes, end.at, axis, upper, draft.skin());
  if (!stop.parallel || std::abs(stop.distance) > within) return end;
  end.at += stop.distance;
  end.rests = true;
  end.std = std::max(kPlaneStd, 0.5 * draft.max_tolerance() / 3.0);
  return end;
}

SeenEnds find_ends(const BoxDraft& draft, const std::vector<const Detection*>& planes) {
  SeenEnds seen;
  const FaceEdges edges = edges_of(draft);
  std::vector<Outline> shown;
  for (int axis = 0; axis < 3; ++axis) {
    for (int upper = 0; upper < 2; ++upper) {
      seen.ends[axis][upper] = find_end(draft, planes, edges, axis, upper, &shown);
    }
  }
  // The radius of an edge can be seen only where two faces meet.
  if (draft.faces.size() > 1) seen.radius = fit_rounded_box(draft, shown, &seen.ends);
  return seen;
}

BoxEnds bounded(const BoxDraft& draft, const std::vector<const Detection*>& planes, BoxEnds ends) {
  const Eigen::AlignedBox3d box_A = seen_part(ends);
  for (int axis = 0; axis < 3; ++axis) {
    for (int upper = 0; upper < 2; ++upper) {
      BoxEnd& end = ends[axis][upper];
      if (!end.seen || end.may_reach > 0.0) end = bounded(draft, planes, box_A, axis, upper, end);
    }
  }
  return ends;
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
