#include "lab/study/grasp_judge.hpp"

#include <algorithm>
#include <cmath>

#include "base/quantile.hpp"

namespace quadrille::study {
namespace {

using Eigen::Vector3d;

// Spacing of the points that represent a surface, and the depth to which the hand may enter it [m].
constexpr double kSpacing = 0.002, kMaxDepth = 0.002;
// The pad touches all points within this distance of the outermost one [m].
constexpr double kContactDepth = 0.0015;
// If one object has a smaller share of the points between the pads, the pads hold two objects.
constexpr double kMinShareOfOne = 0.98;

/// Makes a box in frame G.
Eigen::AlignedBox3d box_of(double half_x, double y_0, double y_1, double z_0, double z_1) {
  return {Vector3d(-half_x, y_0, z_0), Vector3d(half_x, y_1, z_1)};
}

/// Returns fingers and palm at the pre-shape, extended backward along the approach.
std::vector<Eigen::AlignedBox3d> swept_hand(const Gripper& gripper, const Grasp& grasp) {
  const double half = 0.5 * grasp.preshape, thick = half + gripper.finger.y();
  // Fingers on links reach less far while they are open.
  const double tip =
      gripper.finger_front + gripper.extension(grasp.preshape) - gripper.extension(grasp.width);
  const double back = tip - gripper.finger.z() - grasp.approach;
  const double front = -gripper.reach(grasp.width);
  const Vector3d palm = gripper.palm;
  const double finger_x = 0.5 * gripper.finger.x();
  return {box_of(finger_x, half, thick, back, tip), box_of(finger_x, -thick, -half, back, tip),
          box_of(0.5 * palm.x(), -0.5 * palm.y(), 0.5 * palm.y(), front - palm.z() - grasp.approach,
                 front)};
}

}  // namespace

std::string to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::kTouches:
      return "touches";
    case Verdict::kMisses:
      return "misses";
    case Verdict::kSlips:
      return "slips";
    case Verdict::kGood:
      break;
  }
  return "good";
}

GraspJudge::GraspJudge(const physics::TrueScene& scene, const Gripper& gripper, double friction)
    : scene_(scene), gripper_(gripper), friction_(friction) {
  for (const physics::TrueBody& body : scene.bodies) {
    points_.push_back(surface_points(body, kSpacing));
  }
}

Judgement GraspJudge::judge(const Grasp& grasp) const {
  const Between between = between_pads(grasp);
  Judgement judgement{Verdict::kGood, between.object};
  if (grasp.preshape > gripper_.max_opening + 1e-6 || touches(grasp) || is_below_table(grasp)) {
    judgement.verdict = Verdict::kTouches;
  } else if (between.object == nullptr || between.share < kMinShareOfOne) {
    judgement.verdict = Verdict::kMisses;
  } else if (slips(between)) {
    judgement.verdict = Verdict::kSlips;
  }
  return judgement;
}

GraspJudge::Between GraspJudge::between_pads(const Grasp& grasp) const {
  const double half_z = 0.5 * gripper_.pad.y(), half_y = 0.5 * grasp.preshape;
  const Eigen::AlignedBox3d zone = box_of(0.5 * gripper_.pad.x(), -half_y, half_y, -half_z, half_z);
  const Eigen::Isometry3d X_GC = grasp.X_CG.inverse();
  Between between;
  std::size_t most = 0, before = 0;
  for (std::size_t body = 0; body < points_.size(); ++body) {
    for (std::size_t i = 0; i < points_[body].p_C.size(); ++i) {
      const Vector3d p_G = X_GC * points_[body].p_C[i];
      if (!zone.contains(p_G)) continue;
      between.p_G.push_back(p_G);
      between.n_G.emplace_back(X_GC.linear() * points_[body].n_C[i]);
    }
    const std::size_t count = between.p_G.size() - before;
    before = between.p_G.size();
    if (count <= most) continue;
    most = count;
    between.object = &scene_.bodies[body];
  }
  if (most > 0) between.share = static_cast<double>(most) / static_cast<double>(before);
  return between;
}

bool GraspJudge::touches(const Grasp& grasp) const {
  std::vector<Eigen::AlignedBox3d> hand = swept_hand(gripper_, grasp);
  const Vector3d margin = Vector3d::Constant(kMaxDepth);
  for (Eigen::AlignedBox3d& part : hand) part = {part.min() + margin, part.max() - margin};
  const Eigen::Isometry3d X_GC = grasp.X_CG.inverse();
  const auto is_in_hand = [&](const Vector3d& p_C) {
    const Vector3d p_G = X_GC * p_C;
    return std::any_of(hand.begin(), hand.end(),
                       [&](const Eigen::AlignedBox3d& part) { return part.contains(p_G); });
  };
  return std::any_of(points_.begin(), points_.end(), [&](const SurfacePoints& points) {
    return std::any_of(points.p_C.begin(), points.p_C.end(), is_in_hand);
  });
}

bool GraspJudge::is_below_table(const Grasp& grasp) const {
  const Eigen::Isometry3d X_TG = scene_.X_CT.inverse() * grasp.X_CG;
  for (const Eigen::AlignedBox3d& part : swept_hand(gripper_, grasp)) {
    for (int i = 0; i < 8; ++i) {
      const Vector3d corner_G = part.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
      if ((X_TG * corner_G).z() < -kMaxDepth) return true;
    }
  }
  return false;
}

bool GraspJudge::slips(const Between& between) const {
  const double least = std::cos(std::atan(friction_));
  for (const double side : {-1.0, 1.0}) {
    double outermost = -std::numeric_limits<double>::infinity();
    for (const Vector3d& p_G : between.p_G) outermost = std::max(outermost, side * p_G.y());
    std::vector<double> cosines;
    for (std::size_t i = 0; i < between.p_G.size(); ++i) {
      if (side * between.p_G[i].y() < outermost - kContactDepth) continue;
      cosines.push_back(std::abs(between.n_G[i].y()));
    }
    if (median(cosines) < least) return true;
  }
  return false;
}

}  // namespace quadrille::study
