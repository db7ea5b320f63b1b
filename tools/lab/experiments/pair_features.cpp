#include "lab/experiments/pair_features.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace quadrille::experiments {
namespace {

using Eigen::Vector3d;

constexpr int kHeights = 15, kAngles = 30, kModelTurns = 77, kRefinements = 5;
/// Poses that differ by less than this form one group, in radii and [rad].
constexpr double kSameCentre = 0.7, kSameAxis = 0.26;
/// Largest distance of a point that lies on a surface, in radii, and least cosine of its normal.
constexpr double kNear = 0.12, kNearCosine = 0.93;

using Feature = std::array<int, 4>;

/// Returns the distance and the three angles of a pair (paper, eq. 1), in steps.
Feature feature_of(const Vector3d& x1, const Vector3d& n1, const Vector3d& x2, const Vector3d& n2,
                   const PairMatcherOptions& options) {
  const Vector3d d = x2 - x1;
  const Vector3d way = d.normalized();
  const double step = options.distance_step * std::hypot(2.0 * options.radius, options.length);
  const auto angle = [&](const Vector3d& a, const Vector3d& b) {
    return static_cast<int>(std::acos(std::clamp(a.dot(b), -1.0, 1.0)) / options.angle_step);
  };
  return {static_cast<int>(d.norm() / step), angle(n1, way), angle(n2, way), angle(n1, n2)};
}

/// Returns the angle of the direction to x2 about the normal at x1, measured from a tangent
/// direction.
double angle_about(const Vector3d& x1, const Vector3d& n1, const Vector3d& tangent,
                   const Vector3d& x2) {
  const Vector3d d = x2 - x1;
  return std::atan2(n1.cross(tangent).dot(d), tangent.dot(d));
}

/// Position of a pair's reference point on the model, and the angle between the pair and the axis.
struct ModelPair {
  int height;
  double angle;
};
using Model = std::map<Feature, std::vector<ModelPair>>;

double height_of(int step, const PairMatcherOptions& options) {
  return options.length * ((step + 0.5) / kHeights - 0.5);
}

/// Builds all pairs whose first point is on one line of the side, since all its lines are alike.
Model model_of(const PairMatcherOptions& options) {
  Model model;
  const Vector3d n1 = Vector3d::UnitX(), axis = Vector3d::UnitZ();
  for (int i = 0; i < kHeights; ++i) {
    const Vector3d x1 = options.radius * n1 + height_of(i, options) * axis;
    for (int j = 0; j < kHeights; ++j) {
      for (int k = 0; k < kModelTurns; ++k) {
        const double turn = 2.0 * M_PI * k / kModelTurns;
        const Vector3d n2(std::cos(turn), std::sin(turn), 0.0);
        const Vector3d x2 = options.radius * n2 + height_of(j, options) * axis;
        if ((x2 - x1).norm() < 1e-9) continue;
        model[feature_of(x1, n1, x2, n2, options)].push_back({i, angle_about(x1, n1, axis, x2)});
      }
    }
  }
  return model;
}

/// A pose and its number of votes.
struct VotedPose {
  KnownCylinder cylinder;
  double votes;
};

/// Returns the pose that most pairs of one reference point agree on.
VotedPose pose_at(const OrientedPointsd& points, Eigen::Index reference, const Model& model,
                  const PairMatcherOptions& options) {
  const Vector3d x1 = points.points.col(reference), n1 = points.normals.col(reference);
  const Vector3d tangent = n1.unitOrthogonal();
  const double diameter = std::hypot(2.0 * options.radius, options.length);
  std::array<std::array<int, kAngles>, kHeights> votes{};
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    const Vector3d x2 = points.points.col(i);
    const double distance = (x2 - x1).norm();
    if (i == reference || distance > diameter || distance < 1e-9) continue;
    const auto found = model.find(feature_of(x1, n1, x2, points.normals.col(i), options));
    if (found == model.end()) continue;
    const double scene = angle_about(x1, n1, tangent, x2);
    for (const ModelPair& pair : found->second) {
      const double turns = (scene - pair.angle) / (2.0 * M_PI);
      const int bin = static_cast<int>((turns - std::floor(turns)) * kAngles) % kAngles;
      ++votes[static_cast<std::size_t>(pair.height)][static_cast<std::size_t>(bin)];
    }
  }
  VotedPose best{{Vector3d::Zero(), Vector3d::UnitZ(), options.radius}, 0.0};
  for (int h = 0; h < kHeights; ++h) {
    for (int a = 0; a < kAngles; ++a) {
      const int count = votes[static_cast<std::size_t>(h)][static_cast<std::size_t>(a)];
      if (count <= best.votes) continue;
      const double angle = 2.0 * M_PI * (a + 0.5) / kAngles;
      const Vector3d axis = std::cos(angle) * tangent + std::sin(angle) * n1.cross(tangent);
      best.votes = count;
      best.cylinder.axis_C = axis;
      best.cylinder.centre_C = x1 - options.radius * n1 - height_of(h, options) * axis;
    }
  }
  return best;
}

bool is_same(const KnownCylinder& a, const KnownCylinder& b) {
  return (a.centre_C - b.centre_C).norm() < kSameCentre * a.radius &&
         a.axis_C.cross(b.axis_C).norm() < std::sin(kSameAxis);
}

/// Groups poses around the ones with the most votes, and adds up the votes of each group.
std::vector<VotedPose> grouped(std::vector<VotedPose> poses) {
  const auto more = [](const VotedPose& a, const VotedPose& b) { return a.votes > b.votes; };
  std::stable_sort(poses.begin(), poses.end(), more);
  std::vector<VotedPose> groups;
  for (const VotedPose& pose : poses) {
    const auto group = std::find_if(groups.begin(), groups.end(), [&](const VotedPose& g) {
      return is_same(g.cylinder, pose.cylinder);
    });
    if (group == groups.end()) {
      groups.push_back(pose);
    } else {
      group->votes += pose.votes;
    }
  }
  std::stable_sort(groups.begin(), groups.end(), more);
  return groups;
}

/// Returns the points on a cylinder's side.
std::vector<Eigen::Index> points_on(const KnownCylinder& cylinder, const OrientedPointsd& points,
                                    double length) {
  std::vector<Eigen::Index> on;
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    const Vector3d x = points.points.col(i) - cylinder.centre_C;
    const double along = cylinder.axis_C.dot(x);
    const Vector3d out = x - along * cylinder.axis_C;
    if (std::abs(along) < 0.55 * length &&
        std::abs(out.norm() - cylinder.radius) < kNear * cylinder.radius &&
        out.normalized().dot(points.normals.col(i)) > kNearCosine) {
      on.push_back(i);
    }
  }
  return on;
}

/// Fits the axis at right angles to the normals, through the points one radius inside the surface.
void refine(const OrientedPointsd& points, double length, KnownCylinder* cylinder) {
  for (int k = 0; k < kRefinements; ++k) {
    const std::vector<Eigen::Index> on = points_on(*cylinder, points, length);
    if (on.size() < 10) return;
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    Vector3d within = Vector3d::Zero();
    for (const Eigen::Index i : on) {
      const Vector3d n = points.normals.col(i);
      sum += n * n.transpose();
      within += (points.points.col(i) - cylinder->radius * n) / static_cast<double>(on.size());
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(sum);
    const Vector3d axis = solver.eigenvectors().col(0);
    cylinder->centre_C = within + axis * axis.dot(cylinder->centre_C - within);
    cylinder->axis_C = axis;
  }
}

}  // namespace

std::vector<KnownCylinder> match_pairs(const OrientedPointsd& points, double cell,
                                       const PairMatcherOptions& options) {
  const Model model = model_of(options);
  std::vector<VotedPose> poses;
  for (Eigen::Index i = 0; i < points.size(); i += options.reference_step) {
    const VotedPose pose = pose_at(points, i, model, options);
    if (pose.votes > 0) poses.push_back(pose);
  }
  const std::vector<VotedPose> groups = grouped(std::move(poses));
  const double half_side = M_PI * options.radius * options.length;
  std::vector<KnownCylinder> found;
  for (const VotedPose& group : groups) {
    if (group.votes < options.min_votes * groups.front().votes) break;
    KnownCylinder cylinder = group.cylinder;
    refine(points, options.length, &cylinder);
    const auto on = static_cast<double>(points_on(cylinder, points, options.length).size());
    const bool is_new = std::none_of(found.begin(), found.end(), [&](const KnownCylinder& other) {
      return (other.centre_C - cylinder.centre_C).norm() < cylinder.radius;
    });
    if (is_new && on * cell * cell > options.min_cover * half_side) found.push_back(cylinder);
  }
  return found;
}

}  // namespace quadrille::experiments
