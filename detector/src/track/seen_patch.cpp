#include "track/seen_patch.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace quadrille {
namespace {

// Lines through the extent along each side of the grid; some forty points on a face suffice to
// locate it.
constexpr int kLines = 6;
// The ends of an extent are uncertain, so it is widened on each side by this share of the patch's
// size and this many rms.
constexpr double kMarginShare = 0.1, kMarginRms = 2.0;
// A point that lies outside the other patch's extent by this share of the size counts half.
constexpr double kHalfWeightShare = 0.05;
// Least standard deviation of a patch's position [m].
constexpr double kFitLength = 0.002;
// Largest number of Gauss-Newton steps; they end once a step moves the patch by less than this
// share of the size.
constexpr int kMaxRounds = 12;
constexpr double kMinStepShare = 1e-3;
// Weight that pulls the shift towards zero. It is small compared with the share of normals along
// any axis of a curved surface, so it restrains only directions in which the surface slides in
// itself.
constexpr double kRegularisation = 0.003;

/// Adds points of the quadric on grid lines along one axis of the extent, but only where the normal
/// is nearest to that axis: the three axes together cover the surface about evenly.
void add_points_along(int axis, const Quadric& Q_Q, const Eigen::AlignedBox3d& box,
                      const Eigen::Isometry3d& X_WQ, SeenPatch* patch) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const Eigen::Vector3d step = box.sizes() / kLines;
  for (int i = 0; i < kLines * kLines; ++i) {
    Eigen::Vector3d o = box.min();
    o[u] += (i % kLines + 0.5) * step[u];
    o[v] += (i / kLines + 0.5) * step[v];
    for (const double t : Q_Q.crossings(o, Eigen::Vector3d::Unit(axis))) {
      if (!(t >= 0.0 && t <= box.sizes()[axis])) continue;
      const Eigen::Vector3d x = o + t * Eigen::Vector3d::Unit(axis);
      const Eigen::Vector3d g = Q_Q.gradient(x);
      if (!(g.norm() > 0.0) || std::abs(g[axis]) < g.cwiseAbs().maxCoeff()) continue;
      patch->points_W.push_back(X_WQ * x);
      patch->normals_W.push_back(X_WQ.linear() * g.normalized());
    }
  }
}

/// The extent, slightly widened, since a plane's extent is only as thick as its noise.
Eigen::AlignedBox3d widened(const SeenPatch& patch) {
  const Eigen::Vector3d margin =
      Eigen::Vector3d::Constant(kMarginShare * patch.size + kMarginRms * patch.rms);
  return {patch.extent_Q.min() - margin, patch.extent_Q.max() + margin};
}

/// A point of one patch compared with the other's surface, and the effect of a shift of `from`.
struct Meeting {
  /// Signed distance to the other's quadric [m], limited to the larger size of the two patches.
  double distance = 0.0;
  /// Derivative of the distance by the shift.
  Eigen::Vector3d slope = Eigen::Vector3d::Zero();
  /// Distance to the other's extent [m].
  double outside = 0.0;
  double cosine = 1.0;
};

/// Compares the points of `patch`, moved by sign * shift, with the other patch.
void add_meetings(const SeenPatch& patch, const SeenPatch& other, const Eigen::Vector3d& shift_W,
                  double sign, std::vector<Meeting>* meetings) {
  const Eigen::AlignedBox3d box = widened(other);
  const double max_distance = std::max(patch.size, other.size);
  for (std::size_t i = 0; i < patch.points_W.size(); ++i) {
    const Eigen::Vector3d x = patch.points_W[i] + sign * shift_W;
    const Eigen::Vector4d h = other.Q_W.matrix() * x.homogeneous();
    const double length = h.head<3>().norm();
    Meeting meeting;
    meeting.outside = std::sqrt(box.squaredExteriorDistance(other.X_QW * x));
    meeting.distance = max_distance;
    if (length > 0.0) {
      const Eigen::Vector3d n = h.head<3>() / length;
      meeting.distance =
          std::clamp(0.5 * x.homogeneous().dot(h) / length, -max_distance, max_distance);
      meeting.slope = sign * n;
      meeting.cosine = n.dot(patch.normals_W[i]);
    }
    meetings->push_back(meeting);
  }
}

/// Comparisons in both directions; the first `count` belong to the points of `from`.
struct Meetings {
  std::vector<Meeting> list;
  std::size_t count = 0;
};

Meetings meet(const SeenPatch& from, const SeenPatch& to, const Eigen::Vector3d& shift_W) {
  Meetings meetings;
  meetings.list.reserve(from.points_W.size() + to.points_W.size());
  add_meetings(from, to, shift_W, 1.0, &meetings.list);
  meetings.count = meetings.list.size();
  add_meetings(to, from, shift_W, -1.0, &meetings.list);
  return meetings;
}

/// A point outside the other's extent counts little, since the fit is a guess there.
double weight_of(const Meeting& meeting, double size) {
  const double ratio = meeting.outside / (kHalfWeightShare * size);
  return 1.0 / (1.0 + ratio * ratio);
}

/// Finds the least shift that brings the surfaces together.
Eigen::Vector3d find_shift(const SeenPatch& from, const SeenPatch& to) {
  const double size = std::max(from.size, to.size);
  Eigen::Vector3d shift = to.centre_W - from.centre_W;
  for (int round = 0; round < kMaxRounds; ++round) {
    Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    double sum = 0.0;
    for (const Meeting& meeting : meet(from, to, shift).list) {
      const double weight = weight_of(meeting, size);
      H += weight * meeting.slope * meeting.slope.transpose();
      b -= weight * (meeting.distance - meeting.slope.dot(shift)) * meeting.slope;
      sum += weight;
    }
    H.diagonal().array() += kRegularisation * sum + 1e-12;
    const Eigen::Vector3d next = H.ldlt().solve(b);
    const double change = (next - shift).norm();
    shift = next;
    if (change < kMinStepShare * size) break;
  }
  return shift;
}

struct OneWay {
  double outside = 0.0, inside_share = 0.0;
};

OneWay summarise(std::span<const Meeting> meetings) {
  OneWay way;
  for (const Meeting& meeting : meetings) {
    way.outside += meeting.outside;
    way.inside_share += meeting.outside == 0.0;
  }
  const double count = std::max<double>(1.0, static_cast<double>(meetings.size()));
  way.outside /= count;
  way.inside_share /= count;
  return way;
}

}  // namespace

double place_std(const SeenPatch& patch) {
  return std::hypot(patch.rms, kFitShare * patch.size, kFitLength);
}

SeenPatch seen_patch(const Detection& detection, const Eigen::Isometry3d& X_WC) {
  SeenPatch patch;
  const Eigen::Isometry3d X_WQ = X_WC * detection.X_CQ;
  patch.Q_W = detection.Q_C.transformed(X_WC);
  patch.X_QW = X_WQ.inverse();
  patch.extent_Q = detection.extent_Q;
  if (patch.extent_Q.isEmpty()) patch.extent_Q.extend(Eigen::Vector3d(Eigen::Vector3d::Zero()));
  patch.rms = detection.rms;
  const Quadric Q_Q = detection.Q_C.transformed(detection.X_CQ.inverse());
  for (int axis = 0; axis < 3; ++axis) {
    add_points_along(axis, Q_Q, patch.extent_Q, X_WQ, &patch);
  }
  if (patch.points_W.empty()) {
    const Eigen::Vector3d centre = X_WQ * patch.extent_Q.center();
    patch.points_W = {centre};
    patch.normals_W = {patch.Q_W.gradient(centre).normalized()};
  }
  for (const Eigen::Vector3d& x : patch.points_W) patch.centre_W += x;
  patch.centre_W /= static_cast<double>(patch.points_W.size());
  double squares = 0.0;
  for (const Eigen::Vector3d& x : patch.points_W) squares += (x - patch.centre_W).squaredNorm();
  patch.size =
      std::max(patch.size, 2.0 * std::sqrt(squares / static_cast<double>(patch.points_W.size())));
  return patch;
}

SeenPatch translated(SeenPatch patch, const Eigen::Vector3d& shift_W) {
  const Eigen::Isometry3d X(Eigen::Translation3d{shift_W});
  patch.Q_W = patch.Q_W.transformed(X);
  patch.X_QW = patch.X_QW * X.inverse();
  for (Eigen::Vector3d& x : patch.points_W) x += shift_W;
  patch.centre_W += shift_W;
  return patch;
}

PatchMatch match_patches(const SeenPatch& from, const SeenPatch& to) {
  PatchMatch match;
  match.shift_W = find_shift(from, to);
  const Meetings meetings = meet(from, to, match.shift_W);
  const double size = std::max(from.size, to.size);
  double sum = 0.0, squares = 0.0, turns = 0.0;
  for (const Meeting& meeting : meetings.list) {
    const double weight = weight_of(meeting, size);
    sum += weight;
    squares += weight * meeting.distance * meeting.distance;
    const double cosine = std::clamp(meeting.cosine, 0.0, 1.0);
    turns += weight * (1.0 - cosine * cosine);
  }
  match.residual = std::sqrt(squares / sum);
  match.turn = std::sqrt(turns / sum);
  const std::span<const Meeting> all(meetings.list);
  const OneWay there = summarise(all.first(meetings.count));
  const OneWay back = summarise(all.subspan(meetings.count));
  match.gap = std::min(there.outside, back.outside);
  match.overlap = 0.5 * (there.inside_share + back.inside_share);
  return match;
}

}  // namespace quadrille
