#include "contacts/contact_line.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "body/diagonal_quadric.hpp"
#include "contacts/directions.hpp"

namespace quadrille {
namespace {

using Profile = Body::Profile;
constexpr double kPi = std::numbers::pi;
// Numbers of directions that are tried of each kind; neighbours are about 10° apart.
constexpr int kEven = 8, kRing = 16, kLevel = 24, kSpiral = 100;
// Distance between neighbouring heights of the pads' centre [m], and the largest number of heights.
constexpr double kHeightStep = 0.008;
constexpr int kMaxHeightSteps = 16;
// Contacts farther from the pad's middle than this share of its shorter side count as beside it.
constexpr double kMaxOffPad = 0.45;
// Soft pads give by about this much, so that they touch two ends whose radii differ by no more [m].
constexpr double kPadsGive = 0.0005;

/// The line through ±p_Q + offset_Q, with the outward normals at its two ends.
struct Pair {
  Eigen::Vector3d offset_Q, p_Q, closing_Q, n_plus_Q, n_minus_Q;
  double opening, std, lean_std;
};

ContactLine placed(const Body& body, const Pair& pair) {
  const Eigen::Matrix3d& R = body.X_CQ.linear();
  ContactLine line;
  line.centre_C = body.X_CQ * pair.offset_Q;
  line.closing_C = R * pair.closing_Q;
  line.contacts_C = {body.X_CQ * Eigen::Vector3d(pair.offset_Q + pair.p_Q),
                     body.X_CQ * Eigen::Vector3d(pair.offset_Q - pair.p_Q)};
  line.normals_C = {R * pair.n_plus_Q.normalized(), R * pair.n_minus_Q.normalized()};
  line.width = 2.0 * pair.p_Q.dot(pair.closing_Q);
  line.opening = std::max(pair.opening, line.width);
  line.std = pair.std;
  line.lean_std = pair.lean_std;
  return line;
}

/// Returns angles in [0, π): evenly spread ones, more around the direction across the line of
/// sight, and the level direction.
std::vector<double> cross_angles(const Eigen::Vector3d& view_Q, const Eigen::Vector3d& up_Q) {
  std::vector<double> angles;
  angles.reserve(kEven);
  for (int i = 0; i < kEven; ++i) angles.push_back(kPi * i / kEven);
  if (view_Q.head<2>().norm() > 0.1 * view_Q.norm()) {
    const double across = std::atan2(view_Q.y(), view_Q.x()) + 0.5 * kPi;
    for (const double turn : {0.0, -10.0, 10.0, -20.0, 20.0, -32.0, 32.0}) {
      angles.push_back(across + turn * kPi / 180.0);
    }
  }
  if (up_Q.head<2>().norm() > 0.1) angles.push_back(std::atan2(up_Q.y(), up_Q.x()) + 0.5 * kPi);
  return angles;
}

/// Returns the heights of the pads' centre, kept away from the ends by a third of a pad.
std::vector<double> heights(const Body& body, const Gripper& gripper) {
  const double off = std::min(0.35 * gripper.pad.maxCoeff(), 0.25 * (body.z_max - body.z_min));
  const double low = body.z_min + off, high = body.z_max - off;
  const int steps =
      std::clamp(static_cast<int>(std::ceil((high - low) / kHeightStep)), 1, kMaxHeightSteps);
  std::vector<double> z = {0.5 * (low + high)};
  for (int i = 0; i <= steps; ++i) z.push_back(low + (high - low) * i / steps);
  return z;
}

/// Returns the height at which pads meet a body that they hold at height z, from `low` to `high`.
/// Flat pads meet a waist at the end, of themselves or of the body, at which it is wider, and
/// steeper. With the waist between two ends that are equally wide they rest on both, so that they
/// cannot slide.
double meeting_height(const Body& body, double z, double low, double high) {
  if (body.profile != Body::Profile::kHyperbola) return z;
  const double semi_axis = std::max(body.a, body.b);
  const double wider = semi_axis * (body.scale(high) - body.scale(low));
  if (low < 0.0 && high > 0.0 && std::abs(wider) <= kPadsGive) return z;
  return wider >= 0.0 ? high : low;
}

void add_across(const Body& body, const Gripper& gripper, const Eigen::Vector3d& view_Q,
                const Eigen::Vector3d& up_Q, std::vector<ContactLine>& lines) {
  const double reach = 0.5 * gripper.pad.maxCoeff();
  const std::vector<double> angles = cross_angles(view_Q, up_Q);
  for (const double z : heights(body, gripper)) {
    const double s = body.scale(z);
    const double low = std::max(z - reach, body.z_min), high = std::min(z + reach, body.z_max);
    // The profile is convex or concave, so it is widest at an end of the pad or where its slope is
    // zero.
    const double widest = std::max({s, body.scale(low), body.scale(high)});
    const double met = meeting_height(body, z, low, high);
    for (const double angle : angles) {
      const Eigen::Vector3d d(std::cos(angle), std::sin(angle), 0.0);
      const Eigen::Vector3d squared(body.a * body.a, body.b * body.b, 0.0);
      const double h = std::sqrt(d.dot(squared.cwiseProduct(d)));  // half the width at s = 1
      const Eigen::Vector3d p = squared.cwiseProduct(d) * (s / h);
      const Eigen::Vector3d rise(0.0, 0.0, -h * body.slope(met));
      lines.push_back(placed(body, {{0, 0, z},
                                    p,
                                    d,
                                    d + rise,
                                    -d + rise,
                                    2.0 * h * widest,
                                    body.width_std(d, z),
                                    body.lean_std(met)}));
    }
  }
}

/// Adds contacts on both flat ends, or on both planes, at the middle and around it.
void add_end_on(const Body& body, std::vector<ContactLine>& lines) {
  const double middle = 0.5 * (body.z_min + body.z_max);
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  const double half = 0.5 * (body.z_max - body.z_min);
  for (const double x : {0.0, -0.5, 0.5}) {
    for (const double y : {0.0, -0.5, 0.5}) {
      lines.push_back(placed(
          body,
          {{x * body.a, y * body.b, middle}, half * up, up, up, -up, 0.0, body.end_std, 0.0}));
    }
  }
}

/// Returns directions over half a sphere: the principal axes, a ring across the line of sight, and
/// an even spiral.
std::vector<Eigen::Vector3d> sphere_directions(const Eigen::Vector3d& view_Q,
                                               const Eigen::Vector3d& up_Q) {
  std::vector<Eigen::Vector3d> directions = {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(),
                                             Eigen::Vector3d::UnitZ()};
  const Eigen::Vector3d v = view_Q.norm() > 1e-9 ? Eigen::Vector3d(view_Q.normalized())
                                                 : Eigen::Vector3d(Eigen::Vector3d::UnitZ());
  const Eigen::Vector3d e = v.unitOrthogonal();
  const std::vector<Eigen::Vector3d> ring = fan(e, v.cross(e), kRing, kPi);
  for (const double tilt : {0.0, 0.2, -0.2}) {
    for (const Eigen::Vector3d& d : ring) directions.push_back((d + tilt * v).normalized());
  }
  for (const auto& more : {level_directions(up_Q, kLevel), half_sphere(kSpiral)}) {
    directions.insert(directions.end(), more.begin(), more.end());
  }
  return directions;
}

void add_ellipsoid(const Body& body, const Gripper& gripper, const Eigen::Vector3d& view_Q,
                   const Eigen::Vector3d& up_Q, std::vector<ContactLine>& lines) {
  const Eigen::Vector3d squared(body.a * body.a, body.b * body.b, body.c * body.c);
  for (const Eigen::Vector3d& d : sphere_directions(view_Q, up_Q)) {
    const double h = std::sqrt(d.dot(squared.cwiseProduct(d)));
    const Eigen::Vector3d p = squared.cwiseProduct(d) / h;
    if ((p - h * d).norm() > kMaxOffPad * gripper.pad.minCoeff()) continue;
    lines.push_back(
        placed(body, {Eigen::Vector3d::Zero(), p, d, d, -d, 2.0 * h, body.width_std(d, 0.0), 0.0}));
  }
}

}  // namespace

std::optional<ContactLine> chord(const Body& body, const Eigen::Vector3d& p_C,
                                 const Eigen::Vector3d& d_C) {
  if (body.profile == Profile::kBox) return std::nullopt;
  const Eigen::Vector3d p = body.X_CQ.inverse() * p_C;
  const Eigen::Vector3d d = body.X_CQ.linear().transpose() * d_C;
  const DiagonalQuadric q = quadric_of(body);
  const double A = d.dot(q.M.cwiseProduct(d));
  const double B = d.dot(q.M.cwiseProduct(p)) + 0.5 * q.g.dot(d);
  const double C = p.dot(q.M.cwiseProduct(p)) + q.g.dot(p) + q.k;
  const double D = B * B - A * C;
  // The line lies inside the body between its roots exactly if A > 0.
  if (A < 1e-9 * q.M.maxCoeff() || D <= 0.0) return std::nullopt;
  const double t0 = (-B - std::sqrt(D)) / A, t1 = (-B + std::sqrt(D)) / A;
  const Eigen::Vector3d low = p + t0 * d, high = p + t1 * d;
  if (std::min(low.z(), high.z()) < body.z_min || std::max(low.z(), high.z()) > body.z_max) {
    return std::nullopt;
  }
  const auto normal = [&](const Eigen::Vector3d& x) -> Eigen::Vector3d {
    return 2.0 * q.M.cwiseProduct(x) + q.g;
  };
  return placed(body, {0.5 * (low + high), 0.5 * (high - low), d, normal(high), normal(low), 0.0,
                       body.width_std(d, 0.5 * (low.z() + high.z())),
                       std::max(body.lean_std(low.z()), body.lean_std(high.z()))});
}

std::vector<ContactLine> contact_lines(const Body& body, const Gripper& gripper,
                                       const Eigen::Vector3d& viewpoint_C,
                                       const Eigen::Vector3d& up_C) {
  const Eigen::Vector3d view_Q = body.X_CQ.linear().transpose() * (viewpoint_C - body.centre_C());
  const Eigen::Vector3d up_Q = body.X_CQ.linear().transpose() * up_C;
  std::vector<ContactLine> lines;
  if (body.profile == Profile::kEllipse) {
    add_ellipsoid(body, gripper, view_Q, up_Q, lines);
    return lines;
  }
  if (body.profile != Profile::kBox) add_across(body, gripper, view_Q, up_Q, lines);
  if (body.profile == Profile::kConstant || body.profile == Profile::kBox) add_end_on(body, lines);
  return lines;
}

}  // namespace quadrille
