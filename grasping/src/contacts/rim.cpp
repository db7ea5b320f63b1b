#include "contacts/rim.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <utility>

namespace quadrille {
namespace {

// How far to either side a pad holds a wall, as a share of the pad's width: 9 mm on the Franka
// Hand, whose pads are 17.5 mm wide.
constexpr double kReachToPadWidth = 18.0 / 35.0;
// Depths below the rim of the middle of what the pads cover [m], the deepest first. Stereo cameras
// see rims some 10 mm too high, so that pads which hold less than that may close on nothing. Where
// the deepest collides, a shallower one may not. Small pads go no deeper than a share of their
// reach. The pads close along the wall's normal at that depth, since they would turn a bent wall
// otherwise.
constexpr std::array<double, 3> kBites = {0.013, 0.008, 0.0045};
constexpr std::array<double, 3> kMaxBitesToReach = {13.0 / 9.0, 8.0 / 9.0, 1.0 / 2.0};
constexpr int kAround = 36;
// Least number of points at a contact that lie above it; fewer could be noise. If all points lie
// below, the wall ends there, lower than the shell elsewhere, and the pads would close on nothing.
constexpr int kMinNear = 8;
// Least deviation of the wall from these points [m].
constexpr double kMinStd = 0.0005;

Eigen::Vector3d middle(const ContactLine& line) {
  return 0.5 * (line.contacts_C[0] + line.contacts_C[1]);
}

/// Returns how far the wall bends to the inside and outside of its tangent plane within a finger's
/// width, down to `below`, the reach of the tips.
std::pair<double, double> bend(const Shell& shell, double angle, double z, double half_width,
                               double below) {
  const Body& body = shell.body;
  const Eigen::Vector3d p = shell.point_Q(angle, z), n = shell.normal_Q(angle, z);
  const double radius = std::min(body.a, body.b) * body.scale(z);
  const double turn = std::asin(std::min(1.0, half_width / radius));
  double inside = 0.0, outside = 0.0;
  for (const double height : {std::max(body.z_min, z - below), z, body.z_max}) {
    for (const double side : {-turn, 0.0, turn}) {
      const double off = n.dot(shell.point_Q(angle + side, height) - p);
      inside = std::max(inside, -off);
      outside = std::max(outside, off);
    }
  }
  return {inside, outside};
}

ContactLine rim_line(const Shell& shell, double angle, double bite, const Gripper& gripper) {
  const Body& body = shell.body;
  const double z = body.z_max - bite;
  const Eigen::Vector3d p_Q = shell.point_Q(angle, z), n_Q = shell.normal_Q(angle, z);
  const auto [inside, outside] = bend(shell, angle, z, 0.5 * gripper.finger.x(), bite);
  const double low = shell.inner() - inside, high = shell.outer() + outside;
  ContactLine line;
  line.width = 0.5 * (shell.wall.min + shell.wall.max);
  // The grasp is centred midway between the pads on a wall of mean thickness, so that neither pad
  // pushes the vessel far. The opening allows for the thickest wall on either side.
  const double unseen = shell.wall.max - line.width;
  const double middle = 0.5 * (low + high + (shell.seen_inside ? -unseen : unseen));
  line.opening = 2.0 * std::max(high - middle, middle - low);
  line.std = body.width_std(n_Q, z);
  line.closing_C = body.X_CQ.linear() * n_Q;
  const auto at = [&](double off) -> Eigen::Vector3d { return body.X_CQ * (p_Q + off * n_Q); };
  line.centre_C = at(middle);
  line.contacts_C = {at(shell.seen_inside ? line.width : 0.0),
                     at(shell.seen_inside ? 0.0 : -line.width)};
  line.normals_C = {line.closing_C, Eigen::Vector3d(-line.closing_C)};
  return line;
}

/// A point that may belong to the wall.
struct WallPoint {
  Eigen::Vector3d p_C;
  /// Distance from the range where the wall may be [m]; 0 within.
  double beside = 0.0;
  /// Height along the axis of the shell [m].
  double height = 0.0;
};

/// Returns the points of the wall that count for any of the lines.
std::vector<WallPoint> points_near(const std::vector<ContactLine>& lines, double reach,
                                   const Shell& shell, const CloudRuns& cloud) {
  const Eigen::Isometry3d X_QC = shell.body.X_CQ.inverse();
  const double lowest =
      shell.body.z_max - std::min(kBites.front(), kMaxBitesToReach.front() * reach) - reach;
  Eigen::AlignedBox3d near;
  for (const ContactLine& line : lines) near.extend(middle(line));
  near.min().array() -= reach;
  near.max().array() += reach;
  std::vector<WallPoint> points;
  cloud.each_in(with_rounding(near), [&](std::size_t n) {
    const Eigen::Vector3d p_C = cloud.points_C()[n].cast<double>();
    const double height = (X_QC * p_C).z();
    if (!near.contains(p_C) || !(height >= lowest)) return;
    if (!shell.in_wall(p_C, kWallNoise)) return;
    const double off = shell.offset(p_C);
    points.push_back({p_C, off - std::clamp(off, shell.inner(), shell.outer()), height});
  });
  return points;
}

/// Some points of the wall that follow each other, and the box around them. They mostly lie side by
/// side, so that most lines are far from all of them.
struct WallRun {
  std::span<const WallPoint> points;
  Eigen::AlignedBox3d bounds_C;
};

std::vector<WallRun> runs_of(std::span<const WallPoint> wall) {
  constexpr std::size_t kRun = 16;
  std::vector<WallRun> runs;
  for (; !wall.empty(); wall = wall.subspan(runs.back().points.size())) {
    WallRun& run = runs.emplace_back();
    run.points = wall.first(std::min(kRun, wall.size()));
    for (const WallPoint& point : run.points) run.bounds_C.extend(point.p_C);
  }
  return runs;
}

// Far more than what rounding changes in squares of some millimetres [m²].
constexpr double kSlack = 1e-12;

}  // namespace

double rim_reach(const Gripper& gripper) { return kReachToPadWidth * gripper.pad.x(); }

std::vector<ContactLine> rim_lines(const Shell& shell, const Gripper& gripper) {
  std::vector<ContactLine> lines;
  for (std::size_t n = 0; n < kBites.size(); ++n) {
    const double bite = std::min(kBites[n], kMaxBitesToReach[n] * rim_reach(gripper));
    for (int k = 0; k < kAround; ++k) {
      lines.push_back(rim_line(shell, 2.0 * std::numbers::pi * k / kAround, bite, gripper));
    }
  }
  return lines;
}

std::vector<ContactLine> measured_lines(const Shell& shell, const Gripper& gripper,
                                        const std::vector<ContactLine>& lines,
                                        const CloudRuns& cloud) {
  const double reach = rim_reach(gripper);
  const std::vector<WallPoint> wall = points_near(lines, reach, shell, cloud);
  const std::vector<WallRun> runs = runs_of(wall);
  const Eigen::Isometry3d X_QC = shell.body.X_CQ.inverse();
  std::vector<ContactLine> measured;
  for (ContactLine line : lines) {
    const Eigen::Vector3d middle_C = middle(line);
    const double middle_height = (X_QC * middle_C).z();
    int count = 0, above = 0;
    double sum = 0.0;
    for (const WallRun& run : runs) {
      if (run.bounds_C.squaredExteriorDistance(middle_C) > reach * reach + kSlack) continue;
      for (const WallPoint& point : run.points) {
        if ((point.p_C - middle_C).squaredNorm() > reach * reach) continue;
        ++count;
        above += point.height > middle_height;
        sum += point.beside * point.beside;
      }
    }
    if (above < kMinNear) continue;
    line.std = std::max(kMinStd, std::sqrt(sum / count));
    measured.push_back(line);
  }
  return measured;
}

}  // namespace quadrille
