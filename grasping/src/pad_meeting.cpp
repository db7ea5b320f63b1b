#include "pad_meeting.hpp"

#include <algorithm>
#include <cmath>

#include "quadrille/grasping/quality.hpp"

namespace quadrille {

namespace {

// How far from the outermost point the contact may be in truth [m].
constexpr double kDoubt = 0.0015;

// Where a body ends is known no better [m]: there a pad that leans out beyond the end may meet its
// edge in truth. That is more than so much askew.
constexpr double kNearEnd = 0.005, kAskew = 0.1;

// From the tip to the back of a finger, along the approach.
std::array<double, 8> rows(const Gripper& gripper) {
  const double tip = gripper.finger_front, back = tip - gripper.finger.z();
  return {0.0,
          tip,
          0.5 * tip,
          -0.5 * tip,
          -tip,
          0.75 * -tip + 0.25 * back,
          0.5 * (back - tip),
          0.25 * -tip + 0.75 * back};
}

template <class Side>
double farthest(const Side& side) {
  return std::max_element(side.begin(), side.end(),
                          [](const auto& a, const auto& b) { return a.out < b.out; })
      ->out;
}

// The tangent of the mean lean of what may be the contact.
template <class Side>
double lean(const Side& side, double most) {
  double sum = 0.0;
  int count = 0;
  for (const auto& place : side) {
    if (place.out < most - kDoubt) continue;
    sum += place.cosine;
    ++count;
  }
  const double cosine = std::clamp(sum / count, 1e-3, 1.0);
  return std::sqrt(1.0 / (cosine * cosine) - 1.0);
}

}  // namespace

PadMeeter::PadMeeter(const Body& body, const Gripper& gripper)
    : body_(body), gripper_(gripper), quadric_(quadric_of(body)) {}

void PadMeeter::turn(const Eigen::Vector3d& closing_C, const Eigen::Vector3d& approach_C) {
  y_C_ = closing_C;
  y_Q_ = body_.X_CQ.linear().transpose() * closing_C;
  z_Q_ = body_.X_CQ.linear().transpose() * approach_C;
  x_Q_ = y_Q_.cross(z_Q_);
  curvature_ = y_Q_.dot(quadric_.M.cwiseProduct(y_Q_));
}

// The ends of the chord through q along y; false if the hand does not open as far.
bool PadMeeter::add_chord(const Eigen::Vector3d& q_Q) {
  const Eigen::Vector3d& M = quadric_.M;
  const Eigen::Vector3d n_Q = 2.0 * M.cwiseProduct(q_Q) + quadric_.g;  // gradient at q
  const double B = 0.5 * n_Q.dot(y_Q_);
  const double C = 0.5 * (n_Q + quadric_.g).dot(q_Q) + quadric_.k;
  const double D = B * B - curvature_ * C;
  if (D <= 0.0) return true;
  const double root = std::sqrt(D), t0 = (-B - root) / curvature_, t1 = (-B + root) / curvature_;
  const double z0 = q_Q.z() + t0 * y_Q_.z(), z1 = q_Q.z() + t1 * y_Q_.z();
  if (std::min(z0, z1) < body_.z_min || std::max(z0, z1) > body_.z_max) return true;
  const Eigen::Vector3d along = 2.0 * M.cwiseProduct(y_Q_);
  // The gradient along y is ±2√D at the ends.
  sides_[0].push_back({t1, 2.0 * root / (n_Q + t1 * along).norm(), q_Q});
  sides_[1].push_back({-t0, 2.0 * root / (n_Q + t0 * along).norm(), q_Q});
  return t1 - t0 <= gripper_.max_opening;
}

bool PadMeeter::on_edge(const ContactLine& line) const {
  if (body_.profile == Body::Profile::kEllipse) return false;
  for (int i = 0; i < 2; ++i) {
    const double z = (body_.X_CQ.inverse() * line.contacts_C[i]).z();
    const double out = i == 0 ? y_Q_.z() : -y_Q_.z();
    if ((out > kAskew && z > body_.z_max - kNearEnd) ||
        (out < -kAskew && z < body_.z_min + kNearEnd)) {
      return true;
    }
  }
  return false;
}

std::optional<PadMeeting> PadMeeter::at(const Eigen::Vector3d& p_C) {
  for (Side& side : sides_) side.clear();
  if (curvature_ < 1e-9 * quadric_.M.maxCoeff()) return std::nullopt;
  const Eigen::Vector3d p_Q = body_.X_CQ.inverse() * p_C;
  const double half = 0.5 * gripper_.finger.x();
  for (const double along : rows(gripper_)) {
    for (const double across : {0.0, -0.5, 0.5, -1.0, 1.0}) {
      if (!add_chord(p_Q + across * half * x_Q_ + along * z_Q_)) return std::nullopt;
    }
  }
  if (sides_[0].empty()) return std::nullopt;
  const std::array<double, 2> out = {farthest(sides_[0]), farthest(sides_[1])};
  PadMeeting meeting;
  ContactLine& line = meeting.line;
  for (int i = 0; i < 2; ++i) {
    const auto at = std::find_if(sides_[i].begin(), sides_[i].end(),
                                 [&](const Place& place) { return place.out == out[i]; });
    const std::optional<ContactLine> c = chord(body_, body_.X_CQ * at->on_Q, y_C_);
    if (!c) return std::nullopt;  // but for rounding, at the very end
    line.contacts_C[i] = c->contacts_C[i];
    line.normals_C[i] = c->normals_C[i];
    line.std = std::max(line.std, c->std);
  }
  if (on_edge(line)) return std::nullopt;
  line.closing_C = y_C_;
  line.width = line.opening = out[0] + out[1];
  line.centre_C = p_C + 0.5 * (out[0] - out[1]) * y_C_;
  meeting.friction =
      std::max({lean(sides_[0], out[0]), lean(sides_[1], out[1]), friction_needed(line)});
  return meeting;
}

}  // namespace quadrille
