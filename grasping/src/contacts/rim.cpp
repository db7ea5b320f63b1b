#include "contacts/rim.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "view/depth_view.hpp"

namespace quadrille {

namespace {

using Profile = Body::Profile;
constexpr double kPi = std::numbers::pi;

// A mouth that a finger does not enter is none; nor is a dish that the tips would bottom out in
// [m].
constexpr double kMinRadius = 0.02, kMinHeight = 0.02;
// How far below the rim the sensor must have seen past [m], and at which share of the places there:
// the near wall hides the rest.
constexpr double kBelowRim = 0.008, kSeenShare = 0.3;
// Half the edge of the cubes looked through [m].
constexpr double kLook = 0.0015;
// An ellipsoid's mouth faces up within 30°.
constexpr double kUpright = 0.866;
// Points this near to an ellipsoid are its own [m]; so many show where it ends, but for a share of
// stray ones beyond.
constexpr double kOwn = 0.004, kStrayShare = 0.02;
constexpr std::size_t kMinPoints = 100;
// How far a rim may lie above the detection's end, and in which steps it is looked for [m].
constexpr double kMaxRaised = 0.008, kRaise = 0.001;
// How far below the rim the middle of what the pads cover lies [m]: what holds, and what is seen
// from above. The pads close along the wall's normal there: else they would turn a bent wall.
constexpr double kBites[] = {0.0045, 0.0065};
constexpr int kAround = 36;
// Points within half a pad of a contact tell where the wall is there [m]; so few would be noise;
// and no better than this is known what they tell [m].
constexpr double kNearContact = 0.009;
constexpr int kMinNear = 8;
constexpr double kMinStd = 0.0005;

// The same body with its z axis the other way.
Body turned(Body body) {
  body.X_CQ.linear().col(1) *= -1.0;
  body.X_CQ.linear().col(2) *= -1.0;
  std::swap(body.z_min, body.z_max);
  body.z_min *= -1.0;
  body.z_max *= -1.0;
  return body;
}

// An ellipsoid's axis nearest to up_C as its z axis; a sphere's any axis.
std::optional<Body> upright(Body body, const Eigen::Vector3d& up_C) {
  if (body.a == body.b && body.b == body.c) {
    body.X_CQ.linear() =
        Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), up_C).toRotationMatrix();
    return body;
  }
  int k = 0;
  const Eigen::Matrix3d R = body.X_CQ.linear();
  if ((R.transpose() * up_C).cwiseAbs().maxCoeff(&k) < kUpright) return std::nullopt;
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

// Calls visit(p_C) for each point as near to a body's middle as its bounds reach, and some more.
template <class Visitor>
void each_point_near(const PointCloud& cloud, const Body& body, Visitor&& visit) {
  const Eigen::AlignedBox3d box = body.bounds_Q();
  const Eigen::Vector3f middle = (body.X_CQ * Eigen::Vector3d(box.center())).cast<float>();
  const float radius = static_cast<float>(1e-4 + 0.5 * box.diagonal().norm());
  for (const Eigen::Vector3f& p : cloud.points) {
    if ((p - middle).squaredNorm() <= radius * radius) visit(Eigen::Vector3d(p.cast<double>()));
  }
}

// Detections end short of the outermost points. Moves the rim up to where the points on the wall
// end: as long as every millimetre has a third as many as below it.
void raise_to_points(const PointCloud& cloud, Shell& shell) {
  const Eigen::Isometry3d X_QC = shell.body.X_CQ.inverse();
  const double bottom = shell.body.z_max - kBelowRim;
  shell.body.z_max += kMaxRaised;
  const Eigen::AlignedBox3d box = shell.body.bounds_Q();
  std::array<int, static_cast<int>((kBelowRim + kMaxRaised) / kRaise + 0.5)> counts{};
  each_point_near(cloud, shell.body, [&](const Eigen::Vector3d& p_C) {
    const Eigen::Vector3d p_Q = X_QC * p_C;
    const double up = std::floor((p_Q.z() - bottom) / kRaise);
    if (!(up >= 0.0 && up < counts.size()) || !box.contains(p_Q)) return;
    if (std::abs(shell.offset(p_C)) < kOwn) ++counts[static_cast<std::size_t>(up)];
  });
  constexpr std::size_t kBelow = static_cast<std::size_t>(kBelowRim / kRaise + 0.5);
  const int usual = std::accumulate(counts.begin(), counts.begin() + kBelow, 0);
  std::size_t n = kBelow;
  while (n < counts.size() && counts[n] > 0 && counts[n] * 3.0 * kBelow >= usual) ++n;
  shell.body.z_max = bottom + kRaise * static_cast<double>(n);
}

// Ends the body where the points measured on it end; false if too few are.
bool cut_at_points(const PointCloud& cloud, Shell& shell) {
  std::vector<double> heights;
  const Eigen::Isometry3d X_QC = shell.body.X_CQ.inverse();
  const Eigen::AlignedBox3d box = shell.body.bounds_Q();
  each_point_near(cloud, shell.body, [&](const Eigen::Vector3d& p_C) {
    const Eigen::Vector3d p_Q = X_QC * p_C;
    if (box.contains(p_Q) && std::abs(shell.offset(p_C)) < kOwn) heights.push_back(p_Q.z());
  });
  if (heights.size() < kMinPoints) return false;
  const auto last = heights.end() - 1 -
                    static_cast<std::ptrdiff_t>(kStrayShare * static_cast<double>(heights.size()));
  std::nth_element(heights.begin(), last, heights.end());
  shell.body.z_max = *last;
  return true;
}

Eigen::Vector3d middle(const ContactLine& line) {
  return 0.5 * (line.contacts_C[0] + line.contacts_C[1]);
}

bool open_at_top(const Shell& shell, const DepthView& view) {
  const Body& body = shell.body;
  const double z = body.z_max - kBelowRim, s = body.scale(z);
  if (std::min(body.a, body.b) * body.scale(body.z_max) < kMinRadius) return false;
  if (body.z_max - body.z_min < kMinHeight) return false;
  int seen = 0, places = 0;
  for (const double r : {0.25, 0.5, 0.75}) {
    for (int k = 0; k < 12; ++k, ++places) {
      const double t = 2.0 * kPi * k / 12;
      const Eigen::Vector3d p_Q(r * body.a * s * std::cos(t), r * body.b * s * std::sin(t), z);
      seen += view.sees_past(body.X_CQ * p_Q, kLook);
    }
  }
  return seen >= kSeenShare * places;
}

// How far the wall bends to the inside and outside of its tangent plane within a finger's width, as
// far `below` as the tips reach.
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
  // Midway between the pads on a wall of mean thickness, so that neither pushes the vessel far; the
  // opening holds the thickest wall on either side of it.
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

}  // namespace

double Shell::offset(const Eigen::Vector3d& p_C) const {
  const Eigen::Vector3d p = body.X_CQ.inverse() * p_C;
  // f = s(z)·(ρ − 1) in units of the semi-axes, over the length of its gradient.
  const double s = std::max(body.scale(p.z()), 1e-6);
  const double rho = std::hypot(p.x() / body.a, p.y() / body.b);
  if (rho < 1e-9) return -std::min(body.a, body.b) * s;
  const Eigen::Vector3d gradient(p.x() / (body.a * body.a * rho), p.y() / (body.b * body.b * rho),
                                 -body.slope(p.z()));
  return (rho - s) / gradient.norm();
}

bool Shell::in_wall(const Eigen::Vector3d& p_C, double margin) const {
  const double z = (body.X_CQ.inverse() * p_C).z();
  const double off = offset(p_C);
  return z >= body.z_min - margin && z <= body.z_max + margin && off >= inner() - margin &&
         off <= outer() + margin;
}

Eigen::Vector3d Shell::point_Q(double angle, double z) const {
  const double s = body.scale(z);
  return {body.a * s * std::cos(angle), body.b * s * std::sin(angle), z};
}

Eigen::Vector3d Shell::normal_Q(double angle, double z) const {
  return Eigen::Vector3d(std::cos(angle) / body.a, std::sin(angle) / body.b, -body.slope(z))
      .normalized();
}

bool seen_from_inside(const Detection& detection, const Body& body) {
  if (body.profile == Profile::kBox) return false;
  const double z = body.profile == Profile::kEllipse ? 0.0 : 0.5 * (body.z_min + body.z_max);
  const Shell shell{body, false, {}};
  const Eigen::Vector3d p_C = body.X_CQ * shell.point_Q(0.0, z);
  return detection.Q_C.gradient(p_C).dot(body.X_CQ.linear() * shell.normal_Q(0.0, z)) < 0.0;
}

std::optional<Shell> find_shell(const Body& body, bool seen_inside, const PointCloud& cloud,
                                const DepthView& view, const Eigen::Vector3d& up_C,
                                const WallThickness& wall) {
  if (body.profile == Profile::kBox || !view.valid()) return std::nullopt;
  if (body.profile == Profile::kEllipse) {
    if (up_C.norm() < 0.5) return std::nullopt;
    const std::optional<Body> standing = upright(body, up_C);
    if (!standing) return std::nullopt;
    Shell shell{*standing, seen_inside, wall};
    if (!cut_at_points(cloud, shell) || !open_at_top(shell, view)) return std::nullopt;
    return shell;
  }
  Shell shell{body, seen_inside, wall};
  if (!open_at_top(shell, view)) {
    // A vertex is no mouth.
    if (body.profile == Profile::kRoot || body.profile == Profile::kSheet) return std::nullopt;
    shell.body = turned(body);
    if (!open_at_top(shell, view)) return std::nullopt;
  }
  raise_to_points(cloud, shell);
  return shell;
}

std::vector<ContactLine> rim_lines(const Shell& shell, const Gripper& gripper) {
  std::vector<ContactLine> lines;
  for (const double bite : kBites) {
    for (int k = 0; k < kAround; ++k) {
      lines.push_back(rim_line(shell, 2.0 * kPi * k / kAround, bite, gripper));
    }
  }
  return lines;
}

std::vector<ContactLine> measured_lines(const Shell& shell, const std::vector<ContactLine>& lines,
                                        const PointCloud& cloud) {
  // Of each point near the rim, how far it lies beside where the wall may be.
  std::vector<std::pair<Eigen::Vector3d, double>> wall;
  const Eigen::Isometry3d X_QC = shell.body.X_CQ.inverse();
  const double lowest = shell.body.z_max - kBites[1] - kNearContact;
  Eigen::AlignedBox3d near;  // all that counts for any line
  for (const ContactLine& line : lines) near.extend(middle(line));
  near.min().array() -= kNearContact;
  near.max().array() += kNearContact;
  for (const Eigen::Vector3f& p : cloud.points) {
    const Eigen::Vector3d p_C = p.cast<double>();
    if (!near.contains(p_C) || !((X_QC * p_C).z() >= lowest) || !shell.in_wall(p_C, kOwn)) continue;
    const double off = shell.offset(p_C);
    wall.emplace_back(p_C, off - std::clamp(off, shell.inner(), shell.outer()));
  }
  std::vector<ContactLine> measured;
  for (ContactLine line : lines) {
    int count = 0;
    double sum = 0.0;
    for (const auto& [p_C, beside] : wall) {
      if ((p_C - middle(line)).squaredNorm() > kNearContact * kNearContact) continue;
      ++count;
      sum += beside * beside;
    }
    if (count < kMinNear) continue;
    line.std = std::max(kMinStd, std::sqrt(sum / count));
    measured.push_back(line);
  }
  return measured;
}

}  // namespace quadrille
