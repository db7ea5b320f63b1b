#include "quadrille/grasping/looks.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include "contacts/directions.hpp"
#include "scene/sight_lines.hpp"
#include "scene/view_chance.hpp"

namespace quadrille {
namespace {

// Number of directions on half a sphere from which to look; neighbours are some 20° apart.
constexpr int kDirections = 60;
// Directions nearer to the support than this see little of what stands there [rad].
constexpr double kMinElevation = 0.25;
// Planes larger than this are walls or tables, which the camera does not pass [m].
constexpr double kWall = 0.3;
// Distances at which depth cameras measure well [m].
constexpr double kMinDistance = 0.35, kMaxDistance = 0.75;
// A view helps a body only if it shows at least this share of the unknown space about it.
constexpr double kMinShare = 0.15;
// A robot that has no grasp of a body has nothing better to do than to look again, so a view is
// proposed if it gives one to a third of such bodies. One with a grasp can use that at once, so a
// view must more likely than not make it sure.
constexpr double kMinChanceOfFirst = 1.0 / 3.0, kMinChanceOfSure = 0.5;

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

/// A body that lacks a sure grasp, what views may do for it, and the unknown places about it.
struct Doubtful {
  const SceneBody* body = nullptr;
  Prospect prospect;
  Eigen::Vector3d up_C = Eigen::Vector3d::Zero();
  std::vector<Eigen::Vector3d> unknown_C;
  /// The places of the sensor in all views, and the places already chosen for it from which it will
  /// see this body.
  std::vector<Eigen::Vector3d> seen_from_C;

  double min_chance() const { return prospect.has_grasp ? kMinChanceOfSure : kMinChanceOfFirst; }
};

/// The least angle at a place between the direction to one eye and those to others [rad].
double least_angle(const Eigen::Vector3d& at_C, const Eigen::Vector3d& eye_C,
                   const std::vector<Eigen::Vector3d>& others_C) {
  double least = std::numbers::pi;
  const Eigen::Vector3d a = eye_C - at_C;
  for (const Eigen::Vector3d& other_C : others_C) {
    const Eigen::Vector3d b = other_C - at_C;
    least = std::min(least, std::atan2(b.cross(a).norm(), b.dot(a)));
  }
  return least;
}

/// Chooses the best view for bodies.
class LookChooser {
 public:
  LookChooser(const GraspPlan& plan, const std::vector<SceneBody>& bodies,
              const std::vector<Detection>& detections, const Gripper& gripper,
              const PlanOptions& options, const std::vector<Eigen::Vector3d>& viewpoints_C)
      : space_(*plan.space), sight_(*plan.space, bodies), viewpoint_C_(viewpoints_C.front()) {
    for (const Detection& d : detections) {
      const bool large = d.extent_Q.sizes().head<2>().maxCoeff() > kWall;
      if (d.type != QuadricType::kPlane || !large) continue;
      walls_.emplace_back(d.X_CQ.linear().col(2), Eigen::Vector3d(d.X_CQ.translation()));
    }
    for (const SceneBody& body : bodies) {
      const Eigen::Vector3d up_C = up_of(body, detections);
      const Prospect prospect = prospect_of(body, plan, gripper, options, up_C);
      if (prospect.chance == 0.0) continue;
      Doubtful doubtful{&body, prospect, up_C, {}, viewpoints_C};
      doubtful.unknown_C = sight_.unknown_about(body, doubtful.up_C);
      if (!doubtful.unknown_C.empty()) doubtful_.push_back(std::move(doubtful));
    }
  }

  std::vector<Look> choose(int max_looks) {
    std::vector<Rated> chosen;
    while (static_cast<int>(chosen.size()) < max_looks) {
      std::optional<Rated> best = best_look();
      if (!best) break;
      std::erase_if(doubtful_,
                    [&](const Doubtful& d) { return contains(best->look.bodies, d.body->id); });
      const Eigen::Vector3d eye_C = best->look.X_CK.translation();
      const Eigen::Vector3d ahead = best->look.X_CK.linear().col(2);
      for (Doubtful& d : doubtful_) {
        if (sight_.share(d.unknown_C, eye_C, ahead) >= kMinShare) d.seen_from_C.push_back(eye_C);
      }
      chosen.push_back(std::move(*best));
    }
    std::stable_sort(chosen.begin(), chosen.end(), [](const Rated& a, const Rated& b) {
      return std::tie(a.gives_first, a.look.gain) > std::tie(b.gives_first, b.look.gain);
    });
    std::vector<Look> looks;
    looks.reserve(chosen.size());
    for (Rated& rated : chosen) looks.push_back(std::move(rated.look));
    return looks;
  }

 private:
  /// A place at which a camera may look, and the direction in which things stand up there.
  struct Centre {
    Eigen::Vector3d middle_C = Eigen::Vector3d::Zero(), up_C = Eigen::Vector3d::Zero();
  };
  struct Rated {
    Look look;
    /// Whether bodies without a grasp are among those that it helps.
    bool gives_first = false;
    /// Number of bodies without a grasp that are expected to get one, and of all that are expected
    /// to get a better one. Bodies for which that is unlikely are included.
    double first = 0.0, all = 0.0;

    /// Views are sought for bodies without a grasp before all others.
    bool is_better_than(const Rated& other) const {
      if (gives_first != other.gives_first) return gives_first;
      return gives_first ? std::tie(first, all) > std::tie(other.first, other.all)
                         : all > other.all;
    }
  };

  /// The best view for the bodies that still lack one; none if no view is likely to help.
  std::optional<Rated> best_look() const {
    std::optional<Rated> best;
    for (const Centre& centre : centres()) {
      for (const Eigen::Vector3d& eye_C : eyes_about(centre)) {
        Rated rated = look_from(eye_C, centre);
        if (rated.look.bodies.empty()) continue;
        if (!best || rated.is_better_than(*best)) best = std::move(rated);
      }
    }
    return best;
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
    std::vector<std::tuple<bool, double, int>> helped;
    for (const Doubtful& doubtful : doubtful_) {
      const bool has_grasp = doubtful.prospect.has_grasp;
      const double chance = chance_from(eye_C, ahead, doubtful);
      rated.all += chance;
      if (!has_grasp) rated.first += chance;
      if (chance < doubtful.min_chance()) continue;
      rated.gives_first |= !has_grasp;
      helped.emplace_back(has_grasp, -chance, doubtful.body->id);
    }
    std::sort(helped.begin(), helped.end());
    for (const auto& [has_grasp, chance, id] : helped) {
      rated.look.gain -= chance;
      rated.look.bodies.push_back(id);
    }
    rated.look.X_CK = rounded(pose_at(eye_C, ahead, centre.up_C));
    return rated;
  }

  /// The probability that a camera with this line of sight gives a body a grasp, or a sure one.
  double chance_from(const Eigen::Vector3d& eye_C, const Eigen::Vector3d& ahead,
                     const Doubtful& doubtful) const {
    const double share = sight_.share(doubtful.unknown_C, eye_C, ahead);
    if (share < kMinShare) return 0.0;
    const Eigen::Vector3d middle_C = doubtful.body->X_CB.translation();
    const Eigen::Vector3d to_eye = (eye_C - middle_C).normalized();
    return chance_by_view(doubtful.prospect, share,
                          least_angle(middle_C, eye_C, doubtful.seen_from_C),
                          doubtful.up_C.isZero() ? 1.0 : doubtful.up_C.dot(to_eye));
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
  const SightLines sight_;
  const Eigen::Vector3d viewpoint_C_;
  std::vector<Eigen::Hyperplane<double, 3>> walls_;
  std::vector<Doubtful> doubtful_;
};

}  // namespace

std::vector<Look> propose_looks(const GraspPlan& plan, const std::vector<SceneBody>& bodies,
                                const std::vector<Detection>& detections, const Gripper& gripper,
                                const PlanOptions& options,
                                const std::vector<Eigen::Vector3d>& viewpoints_C, int max_looks) {
  if (viewpoints_C.empty()) throw std::invalid_argument("propose_looks() needs a viewpoint");
  if (!plan.space || plan.space->states().empty()) return {};
  return LookChooser(plan, bodies, detections, gripper, options, viewpoints_C).choose(max_looks);
}

}  // namespace quadrille
