#include "tip_holds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "quadrille/grasping/quality.hpp"

namespace quadrille {

namespace {

constexpr double kPi = std::numbers::pi;
// How far the tips reach beyond the nearest point of the body [m].
constexpr double kDips[] = {0.004, 0.008, 0.013, 0.019, 0.027, 0.037};
// Where along the body's breadth: at its middle, near it [m], and as a share of half of it.
constexpr double kNear[] = {0.0, -0.005, 0.005};
constexpr double kBeside[] = {-0.35, 0.35, -0.7, 0.7};
// What of the tip is rounded off [m].
constexpr double kEdge = 0.0012;

// How far from the outermost point the contact may be in truth [m].
constexpr double kDoubt = 0.0015;

// Points all over the surface, in frame C.
std::vector<Eigen::Vector3d> surface(const Body& body) {
  constexpr int kHeights = 9, kAround = 16;
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < kHeights; ++i) {
    // Denser towards the ends, where a profile may close fast.
    const double u = 0.5 - 0.5 * std::cos(kPi * i / (kHeights - 1));
    const double z = (1.0 - u) * body.z_min + u * body.z_max, s = body.scale(z);
    for (int k = 0; k < kAround; ++k) {
      const double t = 2.0 * kPi * k / kAround;
      points.push_back(body.X_CQ *
                       Eigen::Vector3d(body.a * s * std::cos(t), body.b * s * std::sin(t), z));
    }
  }
  return points;
}

// Closing directions over half a sphere: all of it for ellipsoids, else up to 23° askew.
std::vector<Eigen::Vector3d> closings(const Body& body, const Eigen::Vector3d& up_C) {
  std::vector<Eigen::Vector3d> directions;
  const Eigen::Matrix3d& R = body.X_CQ.linear();
  if (body.profile == Body::Profile::kEllipse) {
    constexpr int kSpiral = 60;
    for (int i = 0; i < kSpiral; ++i) {
      const double z = (i + 0.5) / kSpiral, r = std::sqrt(1.0 - z * z);
      const double t = i * kPi * (3.0 - std::sqrt(5.0));
      directions.push_back(R * Eigen::Vector3d(r * std::cos(t), r * std::sin(t), z));
    }
  } else {
    constexpr int kAround = 12;
    for (int k = 0; k < kAround; ++k) {
      const double t = kPi * k / kAround;
      for (const double tilt : {0.0, -0.2, 0.2, -0.4, 0.4}) {
        directions.push_back(R * Eigen::Vector3d(std::cos(t), std::sin(t), tilt).normalized());
      }
    }
  }
  if (up_C.isZero()) return directions;
  const Eigen::Vector3d level = up_C.unitOrthogonal(), other = up_C.cross(level);
  constexpr int kLevel = 12;
  for (int k = 0; k < kLevel; ++k) {
    const double t = kPi * k / kLevel;
    directions.push_back(std::cos(t) * level + std::sin(t) * other);
  }
  return directions;
}

struct Met {
  ContactLine line;
  double friction;
};

// How far two pads of that hand, in frame x, closing, approach, come together on a body.
class Meeting {
 public:
  Meeting(const Body& body, const Gripper& gripper, const Eigen::Vector3d& closing_C,
          const Eigen::Vector3d& approach_C)
      : body_(body), gripper_(gripper), y_(closing_C), z_(approach_C), x_(y_.cross(z_)) {}

  const Eigen::Vector3d& x() const { return x_; }

  /// Where the pads meet the body with the grasp frame's origin on the line of p_C, and the
  /// friction that they need there.
  std::optional<Met> at(const Eigen::Vector3d& p_C) {
    sides_[0].clear();
    sides_[1].clear();
    std::optional<ContactLine> line;
    double low = 0.0, high = 0.0;
    const double side = 0.5 * gripper_.finger.x();
    for (const double along : rows()) {
      for (const double across : {0.0, -0.5, 0.5, -1.0, 1.0}) {
        const std::optional<ContactLine> c =
            chord(body_, p_C + across * side * x_ + along * z_, y_);
        if (!c) continue;
        const double h = (c->contacts_C[0] - p_C).dot(y_), l = (c->contacts_C[1] - p_C).dot(y_);
        sides_[0].push_back({h, c->normals_C[0].dot(y_)});
        sides_[1].push_back({-l, -c->normals_C[1].dot(y_)});
        if (!line) {
          line = c, high = h, low = l;
          continue;
        }
        if (h > high) high = h, take(*c, 0, *line);
        if (l < low) low = l, take(*c, 1, *line);
        if (high - low > gripper_.max_opening) return std::nullopt;
      }
    }
    if (!line) return std::nullopt;
    line->centre_C = p_C + 0.5 * (high + low) * y_;
    line->width = line->opening = high - low;
    const double lean = std::max(lean_of(sides_[0], high), lean_of(sides_[1], -low));
    return Met{*line, std::max(lean, friction_needed(*line))};
  }

 private:
  // A place on a side of the body: how far out, and the cosine of its lean.
  struct Place {
    double out, cosine;
  };

  // The tangent of the mean lean of what may be the contact.
  static double lean_of(const std::vector<Place>& places, double farthest) {
    double sum = 0.0;
    int count = 0;
    for (const Place& place : places) {
      if (place.out < farthest - kDoubt) continue;
      sum += place.cosine;
      ++count;
    }
    const double cosine = std::clamp(sum / count, 1e-3, 1.0);
    return std::sqrt(1.0 / (cosine * cosine) - 1.0);
  }

  std::array<double, 8> rows() const {
    const double tip = gripper_.finger_front,
                 back = gripper_.finger_front - gripper_.finger.z();
    return {0.0,
            tip,
            0.5 * tip,
            -0.5 * tip,
            -tip,
            0.75 * -tip + 0.25 * back,
            0.5 * (back - tip),
            0.25 * -tip + 0.75 * back};
  }

  static void take(const ContactLine& from, int side, ContactLine& to) {
    to.contacts_C[side] = from.contacts_C[side];
    to.normals_C[side] = from.normals_C[side];
    to.std = std::max(to.std, from.std);
  }

  const Body& body_;
  const Gripper& gripper_;
  Eigen::Vector3d y_, z_, x_;
  std::array<std::vector<Place>, 2> sides_;
};

struct Rated {
  TipHold hold;
  double prior;
};

// All depths and places of one orientation of the hand.
void add_holds(const Body& body, const Gripper& gripper, const std::vector<Eigen::Vector3d>& points,
               const Eigen::Vector3d& closing_C, const Eigen::Vector3d& approach_C, double friction,
               double prior, std::vector<Rated>& rated) {
  Meeting meeting(body, gripper, closing_C, approach_C);
  Eigen::Matrix3d R_GC;
  R_GC << meeting.x().transpose(), closing_C.transpose(), approach_C.transpose();
  double nearest = std::numeric_limits<double>::infinity(), farthest = -nearest;
  for (const Eigen::Vector3d& p : points) {
    nearest = std::min(nearest, approach_C.dot(p));
    farthest = std::max(farthest, approach_C.dot(p));
  }
  for (const double dip : kDips) {
    if (nearest + dip > farthest + 0.005) return;
    Eigen::AlignedBox3d reached_G;
    for (const Eigen::Vector3d& p : points) {
      if (approach_C.dot(p) <= nearest + std::max(dip, 0.01)) reached_G.extend(R_GC * p);
    }
    std::vector<double> places(std::begin(kNear), std::end(kNear));
    for (const double share : kBeside) places.push_back(0.5 * share * reached_G.sizes().x());
    for (const double beside : places) {
      Eigen::Vector3d p_G = reached_G.center();
      p_G.x() += beside;
      p_G.z() = nearest + dip - gripper.finger_front;
      const std::optional<Met> met = meeting.at(R_GC.transpose() * p_G);
      if (!met || met->line.width < gripper.min_opening || met->friction > friction) continue;
      rated.push_back({{met->line, approach_C}, prior - met->friction});
    }
  }
}

}  // namespace

std::vector<TipHold> tip_holds(const Body& body, const Gripper& gripper, const ApproachSpace& space,
                               double friction) {
  if (body.profile == Body::Profile::kBox) return {};
  const std::vector<Eigen::Vector3d> points = surface(body);
  std::vector<Rated> rated;
  for (const Eigen::Vector3d& d : closings(body, space.up_C)) {
    const Eigen::Vector3d first = d.unitOrthogonal(), second = d.cross(first);
    constexpr int kDirections = 18;
    const double across = 0.5 * (1.0 - std::abs(d.dot(space.view_C)));
    for (int k = 0; k < kDirections; ++k) {
      const double t = 2.0 * kPi * k / kDirections;
      const Eigen::Vector3d a = std::cos(t) * first + std::sin(t) * second;
      if (!reachable(a, space)) continue;
      const double from = std::max(-a.dot(space.view_C), -a.dot(space.up_C));
      add_holds(body, gripper, points, d, a, friction, across + 0.3 * from, rated);
    }
  }
  std::stable_sort(rated.begin(), rated.end(),
                   [](const Rated& a, const Rated& b) { return a.prior > b.prior; });
  std::vector<TipHold> holds;
  constexpr std::size_t kStride = 16;
  for (std::size_t start = 0; start < kStride; ++start) {
    for (std::size_t n = start; n < rated.size(); n += kStride) holds.push_back(rated[n].hold);
  }
  return holds;
}

}  // namespace quadrille
