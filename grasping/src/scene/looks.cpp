#include "quadrille/grasping/looks.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "contacts/directions.hpp"
#include "scene/view_chance.hpp"

namespace quadrille {
namespace {

// The hand needs to know the space up to this distance from a body [m]: about a finger's thickness,
// its room, and the length that encloses the body.
constexpr double kNeeded = 0.04;
// Round bodies, and those that are guessed in part, are smaller than the boxes around them. A box
// therefore hides only what lies behind its core, whose sides are this share of the box's.
constexpr double kCore = 0.75;
// Number of unknown voxels of a body that are looked at; more give the same shares.
constexpr std::size_t kVoxels = 250;
// Number of directions on half a sphere from which to look; neighbours are some 20° apart.
constexpr int kDirections = 60;
// Directions nearer to the support than this see little of what stands there [rad].
constexpr double kMinElevation = 0.25;
// Planes larger than this are walls or tables, which the camera does not pass [m].
constexpr double kWall = 0.3;
// Half the angle that the camera sees [rad], and distances at which depth cameras measure well [m].
constexpr double kHalfView = 0.4, kMinDistance = 0.35, kMaxDistance = 0.75;
// A view helps a body only if it shows at least this share of the unknown space about it.
constexpr double kMinShare = 0.15;
// A view is proposed to those bodies to which it more likely than not gives a sure grasp.
constexpr double kMinChance = 0.5;

bool contains(const std::vector<int>& list, int value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

/// The normal of the plane on which a body stands, or else of the largest plane; zero if there is
/// none.
Eigen::Vector3d up_of(const SceneBody& body, const std::vector<Detection>& detections) {
  Eigen::Vector3d up = Eigen::Vector3d::Zero();
  int most = 0;
  for (const Detection& d : detections) {
    if (d.type != QuadricType::kPlane) continue;
    if (body.standing_on == d.id) return d.X_CQ.linear().col(2);
    if (d.inliers <= most) continue;
    most = d.inliers;
    up = d.X_CQ.linear().col(2);
  }
  return up;
}

/// The box around a body in its frame, grown by the space that the hand needs.
Eigen::AlignedBox3d needed_box(const SceneBody& body) {
  const Eigen::Vector3d half = (0.5 * body.size).array() + kNeeded;
  return {-half, half};
}

/// The part of the box around a body that hides what lies behind it.
Eigen::AlignedBox3d core_of(const SceneBody& body) {
  const Eigen::Vector3d half = 0.5 * kCore * body.size;
  return {-half, half};
}

/// True if the segment between two points crosses a box.
bool crosses(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  double first = 0.0, last = 1.0;
  for (int k = 0; k < 3; ++k) {
    const double d = b[k] - a[k];
    if (std::abs(d) < 1e-12) {
      if (a[k] < box.min()[k] || a[k] > box.max()[k]) return false;
      continue;
    }
    const double s = (box.min()[k] - a[k]) / d, t = (box.max()[k] - a[k]) / d;
    first = std::max(first, std::min(s, t));
    last = std::min(last, std::max(s, t));
  }
  return first < last;
}

/// A body that lacks a sure grasp, what views may do for it, and the unknown places about it.
struct Doubtful {
  const SceneBody* body = nullptr;
  Prospect prospect;
  Eigen::Vector3d up_C = Eigen::Vector3d::Zero();
  std::vector<Eigen::Vector3d> unknown_C;
};

/// Chooses the best view for bodies.
class LookChooser {
 public:
  LookChooser(const GraspPlan& plan, const std::vector<SceneBody>& bodies,
              const std::vector<Detection>& detections, const Gripper& gripper,
              const PlanOptions& options, const Eigen::Vector3d& viewpoint_C)
      : space_(*plan.space), bodies_(bodies), viewpoint_C_(viewpoint_C) {
    for (const Detection& d : detections) {
      const bool large = d.extent_Q.sizes().head<2>().maxCoeff() > kWall;
      if (d.type != QuadricType::kPlane || !large) continue;
      walls_.emplace_back(d.X_CQ.linear().col(2), Eigen::Vector3d(d.X_CQ.translation()));
    }
    for (const SceneBody& body : bodies) {
      const Eigen::Vector3d up_C = up_of(body, detections);
      const Prospect prospect = prospect_of(body, plan, gripper, options, up_C);
      if (prospect.chance == 0.0) continue;
      Doubtful doubtful{&body, prospect, up_C, {}};
      doubtful.unknown_C = unknown_about(body, doubtful.up_C);
      if (!doubtful.unknown_C.empty()) doubtful_.push_back(std::move(doubtful));
    }
  }

  std::vector<Look> choose(int max_looks) {
    std::vector<Look> looks;
    while (static_cast<int>(looks.size()) < max_looks) {
      std::optional<Rated> best;
      for (const Centre& centre : centres()) {
        for (const Eigen::Vector3d& eye_C : eyes_about(centre)) {
          Rated rated = look_from(eye_C, centre);
          if (rated.look.bodies.empty()) continue;
          if (!best || rated.expected > best->expected) best = std::move(rated);
        }
      }
      if (!best) break;
      std::erase_if(doubtful_,
                    [&](const Doubtful& d) { return contains(best->look.bodies, d.body->id); });
      looks.push_back(std::move(best->look));
    }
    std::stable_sort(looks.begin(), looks.end(),
                     [](const Look& a, const Look& b) { return a.gain > b.gain; });
    return looks;
  }

 private:
  /// A place at which a camera may look, and the direction in which things stand up there.
  struct Centre {
    Eigen::Vector3d middle_C = Eigen::Vector3d::Zero(), up_C = Eigen::Vector3d::Zero();
  };
  struct Rated {
    Look look;
    /// Number of sure grasps that are expected, those of bodies for which it is unlikely included.
    double expected = 0.0;
  };

  /// Unknown places within a finger's reach of a body and above its support, evenly chosen.
  std::vector<Eigen::Vector3d> unknown_about(const SceneBody& body,
                                             const Eigen::Vector3d& up_C) const {
    const Eigen::Isometry3d X_BC = body.X_CB.inverse();
    const Eigen::AlignedBox3d near_B = needed_box(body), core_B = core_of(body);
    const Eigen::Vector3d reach = body.X_CB.linear().cwiseAbs() * near_B.max();
    const Eigen::Array3d corner = space_.corner().cast<double>().array();
    const auto index = [&](const Eigen::Vector3d& p_C) -> Eigen::Vector3i {
      const Eigen::Array3d x = (p_C / space_.resolution()).array().floor() - corner;
      return x.max(0.0).min(space_.size().cast<double>().array() - 1.0).cast<int>();
    };
    const double foot = -0.5 * (body.X_CB.linear().transpose() * up_C).cwiseAbs().dot(body.size);
    const Eigen::Vector3i low = index(body.X_CB.translation() - reach);
    const Eigen::Vector3i high = index(body.X_CB.translation() + reach);
    std::vector<Eigen::Vector3d> unknown;
    for (int k = low.z(); k <= high.z(); ++k) {
      for (int j = low.y(); j <= high.y(); ++j) {
        for (int i = low.x(); i <= high.x(); ++i) {
          if (space_.at(i, j, k) != Voxel::kUnknown) continue;
          const Eigen::Vector3d p_C = space_.centre(i, j, k), p_B = X_BC * p_C;
          if (!near_B.contains(p_B) || core_B.contains(p_B)) continue;
          if (up_C.dot(p_C - body.X_CB.translation()) < foot + space_.resolution()) continue;
          unknown.push_back(p_C);
        }
      }
    }
    const std::size_t step = unknown.size() / kVoxels + 1;
    std::vector<Eigen::Vector3d> some;
    for (std::size_t n = step / 2; n < unknown.size(); n += step) some.push_back(unknown[n]);
    return some;
  }

  /// The middles of all bodies that lack a sure grasp, and last the place between them.
  std::vector<Centre> centres() const {
    std::vector<Centre> all;
    Eigen::Vector3d sum_C = Eigen::Vector3d::Zero();
    double weight = 0.0;
    for (const Doubtful& doubtful : doubtful_) {
      all.push_back({doubtful.body->X_CB.translation(), doubtful.up_C});
      sum_C += doubtful.prospect.chance * all.back().middle_C;
      weight += doubtful.prospect.chance;
    }
    if (all.size() > 1) all.push_back({sum_C / weight, all.front().up_C});
    return all;
  }

  /// Places from which a camera could look at a centre: above its support, and in space that is not
  /// known to be occupied.
  std::vector<Eigen::Vector3d> eyes_about(const Centre& centre) const {
    const Eigen::Vector3d to_eye = viewpoint_C_ - centre.middle_C;
    const double distance = std::clamp(to_eye.norm(), kMinDistance, kMaxDistance);
    const Eigen::Vector3d up = centre.up_C.isZero() ? to_eye.normalized() : centre.up_C;
    std::vector<Eigen::Vector3d> eyes;
    for (const Eigen::Vector3d& half : half_sphere(kDirections)) {
      const Eigen::Vector3d direction = half.dot(up) < 0.0 ? Eigen::Vector3d(-half) : half;
      if (direction.dot(up) < std::sin(kMinElevation)) continue;
      const Eigen::Vector3d eye = centre.middle_C + distance * direction;
      if (space_.at(eye) != Voxel::kOccupied && before_walls(eye)) eyes.push_back(eye);
    }
    return eyes;
  }

  /// True if a place is on the side of all walls and tables from which they were seen.
  bool before_walls(const Eigen::Vector3d& eye_C) const {
    return std::all_of(walls_.begin(), walls_.end(), [&](const auto& wall) {
      return wall.signedDistance(eye_C) * wall.signedDistance(viewpoint_C_) > 0.0;
    });
  }

  Rated look_from(const Eigen::Vector3d& eye_C, const Centre& centre) const {
    const Eigen::Vector3d ahead = (centre.middle_C - eye_C).normalized();
    Rated rated;
    std::vector<std::pair<double, int>> helped;
    for (const Doubtful& doubtful : doubtful_) {
      const double chance = chance_from(eye_C, ahead, doubtful);
      rated.expected += chance;
      if (chance >= kMinChance) helped.emplace_back(-chance, doubtful.body->id);
    }
    std::sort(helped.begin(), helped.end());
    for (const auto& [chance, id] : helped) {
      rated.look.gain -= chance;
      rated.look.bodies.push_back(id);
    }
    rated.look.X_CK = rounded(pose_at(eye_C, ahead, centre.up_C));
    return rated;
  }

  /// The probability that a camera with this line of sight gives a body a sure grasp.
  double chance_from(const Eigen::Vector3d& eye_C, const Eigen::Vector3d& ahead,
                     const Doubtful& doubtful) const {
    int seen = 0;
    for (const Eigen::Vector3d& p_C : doubtful.unknown_C) {
      seen += (p_C - eye_C).normalized().dot(ahead) > std::cos(kHalfView) && sees(eye_C, p_C);
    }
    const double share = static_cast<double>(seen) / static_cast<double>(doubtful.unknown_C.size());
    if (share < kMinShare) return 0.0;
    const Eigen::Vector3d middle_C = doubtful.body->X_CB.translation();
    const Eigen::Vector3d first = viewpoint_C_ - middle_C, now = eye_C - middle_C;
    return chance_by_view(doubtful.prospect, share,
                          std::atan2(first.cross(now).norm(), first.dot(now)),
                          doubtful.up_C.isZero() ? 1.0 : doubtful.up_C.dot(now.normalized()));
  }

  bool sees(const Eigen::Vector3d& eye_C, const Eigen::Vector3d& p_C) const {
    for (const SceneBody& body : bodies_) {
      const Eigen::Isometry3d X_BC = body.X_CB.inverse();
      if (crosses(core_of(body), X_BC * p_C, X_BC * eye_C)) return false;
    }
    const Eigen::Vector3d step = space_.resolution() * (eye_C - p_C).normalized();
    const Eigen::AlignedBox3d bounds = space_.bounds();
    // The voxel itself may touch a surface that hides it from elsewhere.
    for (Eigen::Vector3d at = p_C + 2.0 * step; bounds.contains(at); at += step) {
      if (space_.at(at) == Voxel::kOccupied) return false;
    }
    return true;
  }

  /// The pose of a camera that looks ahead, with the world's up direction upwards in its image.
  static Eigen::Isometry3d pose_at(const Eigen::Vector3d& eye_C, const Eigen::Vector3d& ahead,
                                   const Eigen::Vector3d& up_C) {
    Eigen::Vector3d right = ahead.cross(up_C);
    if (right.norm() < 1e-6) right = ahead.unitOrthogonal();
    right.normalize();
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    X.linear() << right, ahead.cross(right), ahead;
    X.translation() = eye_C;
    return X;
  }

  const OccupancyGrid& space_;
  const std::vector<SceneBody>& bodies_;
  const Eigen::Vector3d viewpoint_C_;
  std::vector<Eigen::Hyperplane<double, 3>> walls_;
  std::vector<Doubtful> doubtful_;
};

}  // namespace

std::vector<Look> propose_looks(const GraspPlan& plan, const std::vector<SceneBody>& bodies,
                                const std::vector<Detection>& detections, const Gripper& gripper,
                                const PlanOptions& options, const Eigen::Vector3d& viewpoint_C,
                                int max_looks) {
  if (!plan.space || plan.space->states().empty()) return {};
  return LookChooser(plan, bodies, detections, gripper, options, viewpoint_C).choose(max_looks);
}

}  // namespace quadrille
