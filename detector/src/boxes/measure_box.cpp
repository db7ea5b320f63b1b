#include "boxes/measure_box.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "boxes/box_axes.hpp"
#include "boxes/box_draft.hpp"
#include "boxes/sight_lines.hpp"

namespace quadrille {
namespace {

// Shortest side of a box [m]: thinner things are sheets, or steps that noise feigns.
constexpr double kMinSide = 0.008;
// If the ends of a side are uncertain by more than this share of it, they belong to two things.
constexpr double kMaxDoubt = 0.15;
// A single face is accepted as a box only if the box is no deeper than this many times the face's
// longer side.
constexpr double kMaxDepthShare = 3.0;
// Least share of each face that was seen to be there; hidden parts do not count.
constexpr double kMinFilled = 0.85;
// Size of a face's corners as a share of its sides, and the share of the corners that must be
// filled, which a disc does not reach.
constexpr double kCorner = 0.12, kMinFilledCorners = 0.65;
// The border of a face may be rounded or cut: its width [m], and at most this share of the side.
constexpr double kFillSkin = 0.004, kMaxFillSkin = 0.1;
// The outermost layer of a box may be rounded and noisy: its thickness [m], and at most this share
// of the side.
constexpr double kSkin = 0.008, kMaxSkinShare = 0.3;
// Largest number of stray points seen through a box or in it, as a share of the points on its
// faces.
constexpr double kMaxSeenWithin = 0.04;

// Least coverage() of a face. This cheap test spares the look at what was seen between its points.
constexpr double kMinCoverage = 0.5;

/// Share of the rectangle around a face that its points cover if each has the area of a pixel.
double coverage(const Face& face) {
  const Eigen::Matrix3d R_CA = box_axes({&face});
  const auto [u0, u1] = face.reach(R_CA.col(1));
  const auto [v0, v1] = face.reach(R_CA.col(2));
  const double pixel = face.pitch * face.pitch / face.cosine;
  return static_cast<double>(face.points_C.size()) * pixel / ((u1 - u0) * (v1 - v0));
}

double uniform_std(double width) { return width / std::sqrt(12.0); }

/// True if a face fills its side of the box.
bool filled(const BoxDraft& draft, int i, const Eigen::AlignedBox3d& box_A) {
  const int u = (i + 1) % 3, v = (i + 2) % 3;
  Eigen::Matrix<double, 3, 2> uv_C;
  uv_C << draft.R_CA.col(u), draft.R_CA.col(v);
  Eigen::Vector2d low(box_A.min()[u], box_A.min()[v]);
  Eigen::Vector2d high(box_A.max()[u], box_A.max()[v]);
  Eigen::Vector2d skin = (kMaxFillSkin * (high - low)).cwiseMin(kFillSkin);
  if (draft.faces.size() == 1) {
    // On a disc the measured edges lie along the middle of its arcs, so the wider rectangle around
    // its points is used, which the disc does not fill.
    skin.setZero();
    std::tie(low.x(), high.x()) = draft.faces[i]->reach(draft.R_CA.col(u));
    std::tie(low.y(), high.y()) = draft.faces[i]->reach(draft.R_CA.col(v));
  }
  const auto filling = [&](const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    return filling_of(*draft.faces[i], uv_C, from, to, draft.seen_through[i]);
  };
  const Eigen::Vector2d from = low + skin, to = high - skin;
  if (filling(from, to).share() < kMinFilled) return false;
  const Eigen::Vector2d corner = kCorner * (to - from);
  Filling corners;
  for (int n = 0; n < 4; ++n) {
    const Eigen::Vector2d at(n & 1 ? to.x() - corner.x() : from.x(),
                             n & 2 ? to.y() - corner.y() : from.y());
    corners += filling(at, at + corner);
  }
  return corners.share() > kMinFilledCorners;
}

bool all_filled(const BoxDraft& draft, const Eigen::AlignedBox3d& box_A) {
  for (int i = 0; i < static_cast<int>(draft.faces.size()); ++i) {
    if (!filled(draft, i, box_A)) return false;
  }
  return true;
}

/// True if nothing but strays was seen through the box or in it.
bool nothing_within(const BoxDraft& draft, const Eigen::AlignedBox3d& box_A) {
  Eigen::AlignedBox3d core_A = box_A;
  const Eigen::Vector3d skin =
      (kMaxSkinShare * box_A.sizes()).cwiseMin(kSkin + draft.max_tolerance());
  core_A.min() += skin;
  core_A.max() -= skin;
  std::size_t on_faces = 0;
  for (const Face* face : draft.faces) on_faces += face->points_C.size();
  return count_seen_within(core_A, draft.X_CA(), draft.around_C, *draft.sight) <
         kMaxSeenWithin * static_cast<double>(on_faces);
}

bool is_solid(const BoxDraft& draft, const BoxEnds& ends) {
  const Eigen::AlignedBox3d box_A = seen_part(ends);
  const Eigen::Vector3d size = box_A.sizes();
  if (size.maxCoeff() > kMaxSide) return false;
  const bool alone = draft.faces.size() == 1;
  // The depth behind a single face is not seen, so its axis is skipped.
  for (int axis = alone ? 1 : 0; axis < 3; ++axis) {
    const double doubt = std::hypot(ends[axis][0].std, ends[axis][1].std);
    if (size[axis] < kMinSide || doubt > kMaxDoubt * size[axis]) return false;
  }
  return all_filled(draft, box_A) && (alone || nothing_within(draft, box_A));
}

/// True if the outline of a single face was seen all around and a plane parallel to it lies below:
/// the face is the top of a box that stands on the plane.
bool is_top(const BoxEnds& ends) {
  for (int axis = 1; axis < 3; ++axis) {
    if (!ends[axis][0].seen || !ends[axis][1].seen) return false;
  }
  const BoxEnd& foot = ends[0][0];
  return foot.rests && foot.may_reach > kMinSide &&
         foot.may_reach < kMaxDepthShare * seen_part(ends).sizes().maxCoeff();
}

/// Lists the ids of the detected faces, the larger ones first, and averages their scores.
void add_faces(const BoxDraft& draft, Box& box) {
  std::vector<const Face*> faces = draft.faces;
  std::stable_sort(faces.begin(), faces.end(), [](const Face* a, const Face* b) {
    return a->points_C.size() > b->points_C.size();
  });
  std::erase_if(faces, [](const Face* face) { return face->id == 0; });
  for (const Face* face : faces) {
    box.faces.push_back(face->id);
    box.score += face->score / static_cast<double>(faces.size());
  }
}

/// Makes the box from a draft and its ends.
Box box_of(const BoxDraft& draft, const BoxEnds& ends) {
  Eigen::AlignedBox3d likely_A = seen_part(ends), outer_A = seen_part(ends);
  for (int axis = 0; axis < 3; ++axis) {
    const auto& [low, high] = ends[axis];
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
  box.inner_B = in_B(seen_part(ends));
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

bool is_rectangular(const Face& face, const DirectionIndex& sight) {
  if (coverage(face) < kMinCoverage) return false;
  const BoxDraft draft = draft_of({&face}, sight);
  return all_filled(draft, seen_part(find_ends(draft, {})));
}

std::optional<Box> measure_box(const std::vector<const Face*>& faces,
                               const std::vector<const Detection*>& planes,
                               const DirectionIndex& sight) {
  const BoxDraft draft = draft_of(faces, sight);
  BoxEnds ends = find_ends(draft, planes);
  if (!is_solid(draft, ends)) return std::nullopt;
  bound_open_ends(draft, planes, &ends);
  if (faces.size() == 1 && !is_top(ends)) return std::nullopt;
  return box_of(draft, ends);
}

}  // namespace quadrille
