#include "contacts/pad_meeting.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/lanes.hpp"
#include "contacts/quality.hpp"

namespace quadrille {
namespace {

// Points this near to the outermost one may be the true contact [m]: pads give by about as much,
// and fits are no more accurate.
constexpr double kContactDoubt = 0.0015;

// The end of a body is known no better than this [m], so a pad that leans out beyond the end may in
// truth meet its edge. A pad leans out if it is askew by more than this.
constexpr double kEndDoubt = 0.005, kMaxAskew = 0.1;

/// Returns the rows of the grid along the approach, all over a finger from its tip to its back [m].
/// The first two, the pad's middle and the tip, are where bodies are mostly too wide.
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

// Columns of the grid across a finger, in halves of its breadth, the middle one first.
constexpr double kColumnsAcross[] = {0.0, -0.5, 0.5, -1.0, 1.0};
// Slack on a bound on friction, since it is computed with floats.
constexpr double kFrictionSlack = 0.01;
// Marks a chord that meets no surface: it lies deeper inside than the end of any chord.
constexpr float kNoSurface = -std::numeric_limits<float>::infinity();

QUADRILLE_INTO_CLONES void take_roots(FloatLanes& values) {
  std::array<float, kFloatLanes> roots;
  std::memcpy(roots.data(), &values, sizeof(values));
  for (float& root : roots) root = std::sqrt(root);
  load(roots.data(), values);
}

}  // namespace

PadMeetingFinder::PadMeetingFinder(const Body& body, const Gripper& gripper,
                                   const Eigen::Vector3d& closing_C,
                                   const Eigen::Vector3d& approach_C)
    : body_(body),
      gripper_(gripper),
      quadric_(quadric_of(body)),
      y_C_(closing_C),
      y_Q_(body.X_CQ.linear().transpose() * closing_C) {
  const Eigen::Vector3d z_Q = body_.X_CQ.linear().transpose() * approach_C, x_Q = y_Q_.cross(z_Q);
  int n = 0;
  for (const double along : rows(gripper_)) {
    for (const double across : kColumnsAcross) {
      from_origin_Q_.col(n++) = across * 0.5 * gripper_.finger.x() * x_Q + along * z_Q;
    }
  }
  for (int i = 0; i < 3; ++i) {
    offsets_[i] = from_origin_Q_.row(i).transpose().cast<float>().array();
  }
  const Eigen::Vector3d My = quadric_.M.cwiseProduct(y_Q_);
  curvature_ = y_Q_.dot(My);
  product_ = (My.transpose() * from_origin_Q_).transpose().cast<float>().array();
  square_ = (quadric_.M.transpose() * from_origin_Q_.cwiseAbs2()).transpose().cast<float>().array();
}

/// Returns true if one chord is longer than a width.
bool PadMeetingFinder::too_wide(const Eigen::Vector3d& q_Q, double max_width) const {
  const Eigen::Vector3d half_gradient = quadric_.M.cwiseProduct(q_Q) + 0.5 * quadric_.g;
  const double B = half_gradient.dot(y_Q_);
  const double C = q_Q.dot(half_gradient) + 0.5 * quadric_.g.dot(q_Q) + quadric_.k;
  const double half = 0.5 * max_width * curvature_;
  const double D = B * B - curvature_ * C;
  if (D <= half * half) return false;
  const double root = std::sqrt(D);
  const double z0 = q_Q.z() - (B + root) / curvature_ * y_Q_.z();
  const double z1 = q_Q.z() - (B - root) / curvature_ * y_Q_.z();
  return std::min(z0, z1) >= body_.z_min && std::max(z0, z1) <= body_.z_max;
}

/// The chords, and the numbers that all of them share.
struct PadMeetingFinder::Crossing {
  const float *product, *square, *x, *y, *z;
  float B, C, A, inverse, g_x, g_y, g_z, p_z, y_z, z_min, z_max;
};

/// Computes the ends of the chords from the roots t of At² + 2Bt + C along q + t·y, and the
/// farthest ends on either side; returns false if no chord has any.
QUADRILLE_VECTOR_CLONES
bool PadMeetingFinder::cross_all(const Crossing& c) {
  static_assert(kChords % kFloatLanes == 0);
  const FloatLanes zero = {}, none = zero + kNoSurface;
  FloatLanes far0 = none, far1 = none;
  for (int n = 0; n < kChords; n += kFloatLanes) {
    FloatLanes product, square, x, y, z;
    load(c.product + n, product), load(c.square + n, square);
    load(c.x + n, x), load(c.y + n, y), load(c.z + n, z);
    const FloatLanes B = product + c.B;
    const FloatLanes C = square + c.C + c.g_x * x + c.g_y * y + c.g_z * z;
    const FloatLanes D = B * B - c.A * C;
    FloatLanes root = D;
    replace_in(~(D > zero), zero, root);
    take_roots(root);
    FloatLanes t0 = (-B - root) * c.inverse, t1 = (root - B) * c.inverse;
    const FloatLanes along = z + c.p_z, z0 = along + t0 * c.y_z, z1 = along + t1 * c.y_z;
    const FloatMasks meets =
        (D > zero) & (z0 >= c.z_min) & (z1 >= c.z_min) & (z0 <= c.z_max) & (z1 <= c.z_max);
    t0 = -t0;
    replace_in(~meets, none, t1), replace_in(~meets, none, t0);
    std::memcpy(out_[0].data() + n, &t1, sizeof(t1));
    std::memcpy(out_[1].data() + n, &t0, sizeof(t0));
    replace_in(~(far0 > t1), t1, far0), replace_in(~(far1 > t0), t0, far1);
  }
  for (int k = 0; k < kFloatLanes; ++k) {
    farthest_[0] = k == 0 || far0[k] > farthest_[0] ? far0[k] : farthest_[0];
    farthest_[1] = k == 0 || far1[k] > farthest_[1] ? far1[k] : farthest_[1];
  }
  return farthest_[0] > kNoSurface;
}

bool PadMeetingFinder::cross(const Eigen::Vector3d& p_Q) {
  const Eigen::Vector3d half_gradient = quadric_.M.cwiseProduct(p_Q) + 0.5 * quadric_.g;
  const double C_p = p_Q.dot(half_gradient) + 0.5 * quadric_.g.dot(p_Q) + quadric_.k;
  const Eigen::Vector3f g = (2.0 * half_gradient).cast<float>();
  const float A = static_cast<float>(curvature_);
  return cross_all({product_.data(), square_.data(), offsets_[0].data(), offsets_[1].data(),
                    offsets_[2].data(), static_cast<float>(half_gradient.dot(y_Q_)),
                    static_cast<float>(C_p), A, 1.0f / A, g.x(), g.y(), g.z(),
                    static_cast<float>(p_Q.z()), static_cast<float>(y_Q_.z()),
                    static_cast<float>(body_.z_min), static_cast<float>(body_.z_max)});
}

/// Returns tan θ, where cos θ is the mean cosine between the closing direction and the normals at
/// all points that may be the contact.
double PadMeetingFinder::lean(int side, double outermost, const Eigen::Vector3d& p_Q) const {
  double sum = 0.0;
  int count = 0;
  for (int n = 0; n < kChords; ++n) {
    if (out_[side][n] < outermost - kContactDoubt) continue;
    const double t = side == 0 ? out_[side][n] : -out_[side][n];
    const Eigen::Vector3d end_Q = p_Q + from_origin_Q_.col(n) + t * y_Q_;
    const Eigen::Vector3d n_Q = 2.0 * quadric_.M.cwiseProduct(end_Q) + quadric_.g;
    sum += std::abs(n_Q.dot(y_Q_)) / n_Q.norm();
    ++count;
  }
  const double cosine = std::clamp(sum / count, 1e-3, 1.0);
  return std::sqrt(1.0 / (cosine * cosine) - 1.0);
}

bool PadMeetingFinder::on_edge(const ContactLine& line) const {
  if (body_.profile == Body::Profile::kEllipse) return false;
  for (int i = 0; i < 2; ++i) {
    const double z = (body_.X_CQ.inverse() * line.contacts_C[i]).z();
    const double out = i == 0 ? y_Q_.z() : -y_Q_.z();
    if ((out > kMaxAskew && z > body_.z_max - kEndDoubt) ||
        (out < -kMaxAskew && z < body_.z_min + kEndDoubt)) {
      return true;
    }
  }
  return false;
}

/// Returns the tangent of the larger angle between the line through two surface points and the
/// normals there.
double PadMeetingFinder::friction_between(const std::array<Eigen::Vector3d, 2>& ends_Q) const {
  const Eigen::Vector3d between = (ends_Q[0] - ends_Q[1]).normalized();
  double min_cosine = 1.0;
  for (const Eigen::Vector3d& end_Q : ends_Q) {
    const Eigen::Vector3d n_Q = 2.0 * quadric_.M.cwiseProduct(end_Q) + quadric_.g;
    min_cosine = std::min(min_cosine, std::abs(n_Q.dot(between)) / n_Q.norm());
  }
  return std::sqrt(1.0 / std::max(min_cosine * min_cosine, 1e-6) - 1.0);
}

std::optional<PadMeeting> PadMeetingFinder::at(const Eigen::Vector3d& p_C, double max_friction,
                                               double max_width) {
  max_width = std::min(max_width, gripper_.max_opening);
  if (curvature_ < 1e-9 * quadric_.M.maxCoeff()) return std::nullopt;
  const Eigen::Vector3d p_Q = body_.X_CQ.inverse() * p_C;
  // This cheap test comes first: most bodies that are too wide are so at the pads' middle or tips.
  for (const int n : {0, kColumns}) {
    if (too_wide(p_Q + from_origin_Q_.col(n), max_width)) return std::nullopt;
  }
  if (!cross(p_Q)) return std::nullopt;
  const std::array<double, 2> out = {farthest_[0], farthest_[1]};
  if (out[0] + out[1] > max_width) return std::nullopt;
  std::array<int, 2> at;
  for (int i = 0; i < 2; ++i) {
    at[i] =
        static_cast<int>(std::find(out_[i].begin(), out_[i].end(), farthest_[i]) - out_[i].begin());
  }
  // The friction at the ends alone rules out most holds that need too much of it.
  const std::array<Eigen::Vector3d, 2> ends_Q = {p_Q + from_origin_Q_.col(at[0]) + out[0] * y_Q_,
                                                 p_Q + from_origin_Q_.col(at[1]) - out[1] * y_Q_};
  if (friction_between(ends_Q) > max_friction + kFrictionSlack) return std::nullopt;
  PadMeeting meeting;
  ContactLine& line = meeting.line;
  for (int i = 0; i < 2; ++i) {
    const Eigen::Vector3d q_C = body_.X_CQ * Eigen::Vector3d(p_Q + from_origin_Q_.col(at[i]));
    const std::optional<ContactLine> c = chord(body_, q_C, y_C_);
    if (!c) return std::nullopt;  // possible only by rounding, at the very end
    line.contacts_C[i] = c->contacts_C[i];
    line.normals_C[i] = c->normals_C[i];
    line.std = std::max(line.std, c->std);
    line.lean_std = std::max(line.lean_std, c->lean_std);
  }
  if (on_edge(line)) return std::nullopt;
  line.closing_C = y_C_;
  line.width = line.opening = out[0] + out[1];
  line.centre_C = p_C + 0.5 * (out[0] - out[1]) * y_C_;
  const double lean_most = std::max(lean(0, out[0], p_Q), lean(1, out[1], p_Q));
  meeting.friction = std::max(lean_most, friction_needed(line));
  if (doubted_friction(meeting.friction, line.lean_std) > max_friction) return std::nullopt;
  return meeting;
}

}  // namespace quadrille
