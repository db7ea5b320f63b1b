#include "boxes/measure_box.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "boxes/box_axes.hpp"
#include "boxes/box_draft.hpp"
#include "boxes/box_ends.hpp"
#include "boxes/rounded_box.hpp"
#include "boxes/sight_lines.hpp"
#include "boxes/upright_face.hpp"

namespace quadrille {
namespace {

// A face of a box, and its corners, must be seen over at least this share of their areas that are
// not hidden. A disc fills no corners.
constexpr double kMinFilled = 0.7;
// The corners of an upright face, which may be worn, must be seen over at least this share. The
// strip of a cylinder that passes for a plane fills less of its corners.
constexpr double kMinWornCorners = 0.55;
// Size of a face's corners as a share of its sides.
constexpr double kCorner = 0.12;

// The unseen side of a box bulges as the side before it does, give or take this share.
constexpr double kBulgeStd = 0.5;

// Score of a box of which no face was detected.
constexpr double kUndetectedScore = 0.5;
// Least share of the points in a box that lie on its sides and the edges between them.
constexpr double kMinOnFaces = 0.85;

/// The shares of a side of a box, and of its corners, at which its face was seen.
struct Filled {
  double side = 0.0, corners = 0.0;
};

Filled filled(const BoxDraft& draft, int i, const Eigen::AlignedBox3d& box_A) {
  const int u = (i + 1) % 3, v = (i + 2) % 3;
  Eigen::Matrix<double, 3, 2> uv_C;
  uv_C << draft.R_CA.col(u), draft.R_CA.col(v);
  const Eigen::Vector2d from(box_A.min()[u], box_A.min()[v]), to(box_A.max()[u], box_A.max()[v]);
  const auto filling = [&](const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
    return filling_of(*draft.faces[i], uv_C, low, high, draft.seen_through[i]);
  };
  const Eigen::Vector2d corner = kCorner * (to - from);
  Filling corners;
  for (int n = 0; n < 4; ++n) {
    const Eigen::Vector2d at(n & 1 ? to.x() - corner.x() : from.x(),
                             n & 2 ? to.y() - corner.y() : from.y());
    corners += filling(at, at + corner);
  }
  return {filling(from, to).share(), corners.share()};
}

/// True if a face fills its side of a box.
bool is_filled(const Filled& filled) {
  return filled.side >= kMinFilled && filled.corners > kMinFilled;
}

bool all_filled(const BoxDraft& draft, const Eigen::AlignedBox3d& box_A) {
  const Eigen::AlignedBox3d core_A = draft.core_A(box_A);
  for (int i = 0; i < static_cast<int>(draft.faces.size()); ++i) {
    if (!is_filled(filled(draft, i, core_A))) return false;
  }
  return true;
}

/// True if nothing but strays was seen through the box or in it.
bool nothing_within(const BoxDraft& draft, const Eigen::AlignedBox3d& box_A) {
  return count_seen_within(draft.core_A(box_A), draft.X_CA(), draft.around_C, *draft.sight) <=
         draft.max_strays();
}

/// True if most of the points in the box lie on its faces, on its other sides or on the edges
/// between them: the third side of a box may have too few points for a face. On a round body they
/// lie between two faces that only touch it.
bool on_faces(const BoxDraft& draft, const RoundedBox& box) {
  const double tolerance = draft.max_tolerance();
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(tolerance);
  const Eigen::AlignedBox3d around_A(box.box_A.min() - margin, box.box_A.max() + margin);
  int in_box = 0, on = 0;
  for (const Eigen::Vector3d& p_C : draft.around_C) {
    const Eigen::Vector3d p_A = draft.R_CA.transpose() * p_C;
    if (!around_A.contains(p_A)) continue;
    ++in_box;
    on += std::any_of(
              draft.faces.begin(), draft.faces.end(),
              [&](const Face* face) { return std::abs(face->height(p_C)) <= face->tolerance(); }) ||
          std::abs(box.distance(p_A)) <= tolerance;
  }
  return on > kMinOnFaces * in_box;
}

bool is_solid(const BoxDraft& draft, const SeenEnds& seen) {
  const Eigen::AlignedBox3d box_A = seen_part(seen.ends);
  const Eigen::Vector3d size = box_A.sizes();
  if (!(size.maxCoeff() <= kMaxSide)) return false;
  const bool alone = draft.faces.size() == 1;
  // The depth behind a single face is not seen, so its axis is skipped.
  for (int axis = alone ? 1 : 0; axis < 3; ++axis) {
    const double doubt = std::hypot(seen.ends[axis][0].std, seen.ends[axis][1].std);
    if (!(doubt <= kMaxDoubt * size[axis])) return false;
  }
  return alone || (all_filled(draft, box_A) && nothing_within(draft, box_A) &&
                   on_faces(draft, {box_A, seen.radius}));
}

/// True if the outline of a single face was seen all around and a plane parallel to it lies below:
/// the face is the top of a box that stands on the plane.
bool is_top(const BoxEnds& ends) {
  for (int axis = 1; axis < 3; ++axis) {
    if (!ends[axis][0].seen || !ends[axis][1].seen) return false;
  }
  const BoxEnd& foot = ends[0][0];
  return foot.rests && foot.may_reach > kRounding;
}

/// Lists the ids of the detected faces, the larger ones first, and averages their scores.
void add_faces(const BoxDraft& draft, Box& box) {
  std::vector<const Face*> faces = draft.faces;
  std::stable_sort(faces.begin(), faces.end(), [](const Face* a, const Face* b) {
    return a->points_C.size() > b->points_C.size();
  });
  std::erase_if(faces, [](const Face* face) { return face->id == 0; });
  if (faces.empty()) box.score = kUndetectedScore;
  for (const Face* face : faces) {
    box.faces.push_back(face->id);
    box.score += face->score / static_cast<double>(faces.size());
  }
}

/// How far a face likely bulges [m]: what was measured, less so the more noise it has. Even the
/// waves of a flat face look like a small bulge.
double likely_bulge(const Face& face) {
  const double measured = face.bulge * face.bulge, noise = face.bulge_std * face.bulge_std;
  return measured > 0.0 ? face.bulge * measured / (measured + noise) : 0.0;
}

/// Moves the ends to where the faces bulge most. A face lies at the middle of its points, and what
/// bulges on one side, as a full package does, bulges likely alike on the other, where only the
/// outline was seen.
BoxEnds bulging(const BoxDraft& draft, BoxEnds ends) {
  for (int axis = 0; axis < static_cast<int>(draft.faces.size()); ++axis) {
    const Face& face = *draft.faces[axis];
    const double bulge = likely_bulge(face);
    for (int upper = 0; upper < 2; ++upper) {
      BoxEnd& end = ends[axis][upper];
      if (draft.face_on(axis, upper)) {
        end.at += bulge;
        end.std = std::hypot(end.std, std::min(bulge, face.bulge_std));
      } else if (end.seen && !end.rests) {
        end.at += bulge;
        end.hidden += bulge;
        end.std = std::hypot(end.std, kBulgeStd * bulge);
      }
    }
  }
  return ends;
}

/// Makes the box from a draft and its ends.
Box box_of(const BoxDraft& draft, const BoxEnds& ends) {
  Eigen::AlignedBox3d inner_A = seen_part(ends), likely_A = inner_A, outer_A = inner_A;
  for (int axis = 0; axis < 3; ++axis) {
    const auto& [low, high] = ends[axis];
    inner_A.min()[axis] += low.hidden;
    inner_A.max()[axis] -= high.hidden;
    likely_A.min()[axis] -= low.likely;
    likely_A.max()[axis] += high.likely;
    outer_A.min()[axis] -= low.may_reach;
    outer_A.max()[axis] += high.may_reach;
  }
  std::array<int, 3> order = {0, 1, 2};
  const Eigen::Vector3d size_A = likely_A.sizes();
  std::stable_sort(order.begin(), order.end(), [&](int i, int k) { return size_A[i] > size_A[k]; });
  const Eigen::Vector3d middle_C = draft.R_CA * likely_A.center();
  const Eigen::Vector3d to_eye_C = draft.sight->eye() - middle_C;

  Eigen::Matrix3d R_AB = Eigen::Matrix3d::Zero();
  for (int k = 0; k < 3; ++k) {
    const double side = draft.R_CA.col(order[k]).dot(to_eye_C) < 0.0 ? -1.0 : 1.0;
    R_AB(order[k], k) = side;
  }
  if (R_AB.determinant() < 0.0) R_AB.col(1) *= -1.0;
  const auto in_B = [&](const Eigen::AlignedBox3d& box_A) {
    const Eigen::Vector3d a = R_AB.transpose() * (box_A.min() - likely_A.center());
    const Eigen::Vector3d b = R_AB.transpose() * (box_A.max() - likely_A.center());
    return Eigen::AlignedBox3d(a.cwiseMin(b), a.cwiseMax(b));
  };
  Box box;
  box.X_CB.linear() = draft.R_CA * R_AB;
  box.X_CB.translation() = middle_C;
  box.inner_B = in_B(inner_A);
  box.outer_B = in_B(outer_A);
  for (int k = 0; k < 3; ++k) {
    const auto& [low, high] = ends[order[k]];
    box.size[k] = size_A[order[k]];
    box.std[k] = std::hypot(std::hypot(low.std, high.std),
                            std::hypot(uniform_std(low.may_reach), uniform_std(high.may_reach)));
    box.seen[k] = low.seen && high.seen;
  }
  add_faces(draft, box);
  return box;
}

}  // namespace

Rectangle rectangle_of(const BoxDraft& draft) {
  // On a disc the measured edges lie along the middle of its arcs, so the wider rectangle around
  // its points is used, which the disc does not fill.
  const Filled all = filled(draft, 0, draft.reach_A);
  if (is_filled(all)) return Rectangle::kSharp;
  const bool worn = all.side >= kMinFilled && all.corners > kMinWornCorners;
  return worn ? Rectangle::kWorn : Rectangle::kNone;
}

std::optional<Box> measure_box(const BoxDraft& draft, const std::vector<const Detection*>& planes) {
  const SeenEnds seen = find_ends(draft, planes);
  if (!is_solid(draft, seen)) return std::nullopt;
  return box_of(draft, bounded(draft, planes, bulging(draft, seen.ends)));
}

std::optional<Box> measure_top(const BoxDraft& draft, const std::vector<const Detection*>& planes) {
  const SeenEnds seen = find_ends(draft, planes);
  if (!is_solid(draft, seen)) return std::nullopt;
  const BoxEnds ends = bounded(draft, planes, bulging(draft, seen.ends));
  return is_top(ends) ? std::optional(box_of(draft, ends)) : std::nullopt;
}

std::optional<Box> measure_upright(const BoxDraft& draft,
                                   const std::vector<const Detection*>& planes) {
  const SeenEnds seen = find_ends(draft, planes);
  if (!is_solid(draft, seen)) return std::nullopt;
  const auto ends =
      find_upright_ends(draft, planes, bounded(draft, planes, bulging(draft, seen.ends)));
  return ends ? std::optional(box_of(draft, *ends)) : std::nullopt;
}

}  // namespace quadrille
