#include "body/find_shell.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>
#include <vector>

namespace quadrille {
namespace {

using Profile = Body::Profile;
constexpr double kPi = std::numbers::pi;

// Least radius of the mouth and least height of a vessel [m]; smaller hollows are ignored.
constexpr double kMinMouth = 0.02, kMinHeight = 0.02;
// An end is open if, at this depth below the rim [m], the sensor saw past at least this share of
// the places. The near wall hides the rest.
constexpr std::size_t kStepsBelow = 8;
constexpr double kRaiseStep = 0.001;
constexpr double kBelowRim = kStepsBelow * kRaiseStep, kMinSeenShare = 0.3;
// Half the edge of the cubes that are tested for being seen through [m]: about the size of a pixel
// at one metre.
constexpr double kLookHalfEdge = 0.0015;
// Cosine of the widest angle between an ellipsoid's mouth and straight up: 30°.
constexpr double kMinUpright = 0.866;
// An ellipsoid ends where its points end, but for a share of stray points beyond. Fewer points than
// this do not show the end.
constexpr std::size_t kMinPoints = 100;
constexpr double kStrayShare = 0.02;
// Greatest distance by which a rim may lie above the end of the detection, and the step of the
// search for it [m].
constexpr std::size_t kStepsRaised = 8;
constexpr double kMaxRaised = kStepsRaised * kRaiseStep;

/// Makes the ellipsoid's axis that is nearest to up_C its z axis; for a sphere any axis will do.
std::optional<Body> upright(Body body, const Eigen::Vector3d& up_C) {
  if (body.a == body.b && body.b == body.c) {
    body.X_CQ.linear() =
        Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), up_C).toRotationMatrix();
    return body;
  }
  int k = 0;
  const Eigen::Matrix3d R = body.X_CQ.linear();
  if ((R.transpose() * up_C).cwiseAbs().maxCoeff(&k) < kMinUpright) return std::nullopt;
  const Eigen::Vector3d semi(body.a, body.b, body.c), std = body.std;
  for (int i = 0; i < 3; ++i) {
    const int from = (k + 1 + i) % 3;  // cyclic, so that the frame stays right-handed
    body.X_CQ.linear().col(i) = R.col(from);
    (i == 0 ? body.a : i == 1 ? body.b : body.c) = semi[from];
    body.std[i] = std[from];
  }
  body.z_min = -body.c;
  body.z_max = body.c;
  return body.X_CQ.linear().col(2).dot(up_C) < 0.0 ? turned(body) : body;
}

/// Calls visit(p_C) for each point within the bounding sphere of a body, which also includes some
/// points outside the body.
template <class Visitor>
void each_point_near(const CloudRuns& cloud, const Body& body, Visitor&& visit) {
  const Eigen::AlignedBox3d box = body.bounds_Q();
  const Eigen::Vector3f middle = (body.X_CQ * Eigen::Vector3d(box.center())).cast<float>();
  const float radius = static_cast<float>(1e-4 + 0.5 * box.diagonal().norm());
  const Eigen::Vector3f reach = Eigen::Vector3f::Constant(1.001f * radius);
  cloud.each_in({middle - reach, middle + reach}, [&](std::size_t n) {
    const Eigen::Vector3f& p = cloud.points_C()[n];
    if ((p - middle).squaredNorm() <= radius * radius) visit(Eigen::Vector3d(p.cast<double>()));
  });
}

/// Detections end short of the outermost points. This moves the rim up to where the points on the
/// wall end: as long as every millimetre holds at least a third of the average count below the rim.
void raise_to_points(const CloudRuns& cloud, Shell& shell) {
  const Eigen::Isometry3d X_QC = shell.body.X_CQ.inverse();
  const double bottom = shell.body.z_max - kBelowRim;
  shell.body.z_max += kMaxRaised;
  const Eigen::AlignedBox3d box = shell.body.bounds_Q();
  std::array<int, kStepsBelow + kStepsRaised> counts{};
  each_point_near(cloud, shell.body, [&](const Eigen::Vector3d& p_C) {
    const Eigen::Vector3d p_Q = X_QC * p_C;
    const double up = std::floor((p_Q.z() - bottom) / kRaiseStep);
    if (!(up >= 0.0 && up < counts.size()) || !box.contains(p_Q)) return;
    if (std::abs(shell.offset(p_C)) < kWallNoise) ++counts[static_cast<std::size_t>(up)];
  });
  constexpr std::size_t kBelow = kStepsBelow;
  const int usual = std::accumulate(counts.begin(), counts.begin() + kBelow, 0);
  std::size_t n = kBelow;
  while (n < counts.size() && counts[n] > 0 && counts[n] * 3.0 * kBelow >= usual) ++n;
  shell.body.z_max = bottom + kRaiseStep * static_cast<double>(n);
}

/// Cuts the body where the points measured on it end; returns false if there are too few.
bool cut_at_points(const CloudRuns& cloud, Shell& shell) {
  std::vector<double> heights;
  const Eigen::Isometry3d X_QC = shell.body.X_CQ.inverse();
  const Eigen::AlignedBox3d box = shell.body.bounds_Q();
  each_point_near(cloud, shell.body, [&](const Eigen::Vector3d& p_C) {
    const Eigen::Vector3d p_Q = X_QC * p_C;
    if (box.contains(p_Q) && std::abs(shell.offset(p_C)) < kWallNoise) heights.push_back(p_Q.z());
  });
  if (heights.size() < kMinPoints) return false;
  const auto last = heights.end() - 1 -
                    static_cast<std::ptrdiff_t>(kStrayShare * static_cast<double>(heights.size()));
  std::nth_element(heights.begin(), last, heights.end());
  shell.body.z_max = *last;
  return true;
}

bool open_at_top(const Shell& shell, std::span<const DepthView> views) {
  const Body& body = shell.body;
  const double z = body.z_max - kBelowRim, s = body.scale(z);
  if (std::min(body.a, body.b) * body.scale(body.z_max) < kMinMouth) return false;
  if (body.z_max - body.z_min < kMinHeight) return false;
  int seen = 0, places = 0;
  for (const double r : {0.25, 0.5, 0.75}) {
    for (int k = 0; k < 12; ++k, ++places) {
      const double t = 2.0 * kPi * k / 12;
      const Eigen::Vector3d p_Q(r * body.a * s * std::cos(t), r * body.b * s * std::sin(t), z);
      seen += any_sees_past(views, body.X_CQ * p_Q, kLookHalfEdge);
    }
  }
  return seen >= kMinSeenShare * places;
}

}  // namespace

std::optional<Shell> find_shell(const Body& body, bool seen_inside, const CloudRuns& cloud,
                                std::span<const DepthView> views, const Eigen::Vector3d& up_C,
                                const WallThickness& wall) {
  if (body.profile == Profile::kBox) return std::nullopt;
  if (body.profile == Profile::kEllipse) {
    if (up_C.norm() < 0.5) return std::nullopt;
    const std::optional<Body> standing = upright(body, up_C);
    if (!standing) return std::nullopt;
    Shell shell{*standing, seen_inside, wall};
    if (!cut_at_points(cloud, shell) || !open_at_top(shell, views)) return std::nullopt;
    return shell;
  }
  Shell shell{body, seen_inside, wall};
  if (!open_at_top(shell, views)) {
    // The closed end of a paraboloid or hyperboloid sheet is a vertex, which is not a mouth.
    if (body.profile == Profile::kRoot || body.profile == Profile::kSheet) return std::nullopt;
    shell.body = turned(body);
    if (!open_at_top(shell, views)) return std::nullopt;
  }
  raise_to_points(cloud, shell);
  return shell;
}

}  // namespace quadrille
