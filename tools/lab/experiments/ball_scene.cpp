#include "lab/experiments/ball_scene.hpp"

#include <algorithm>
#include <cmath>

#include "lab/scene/bodies.hpp"

namespace quadrille::experiments {
namespace {

using Eigen::Vector3d;

/// Half the length of the path along the table, and the height of a lift [m].
constexpr double kReach = 0.25, kLiftHeight = 0.25;
/// Half the angle of the camera's arc [rad], and the sine of its elevation.
constexpr double kCircle = 0.6, kElevation = 0.5;

/// The lowest point of the ball, standing or hanging, and its rotation about y.
struct BallPlace {
  Vector3d foot = Vector3d::Zero();
  double turn = 0.0;
};

BallPlace place_at(const GeneratedSequence& sequence, double time) {
  const double along = kReach * (2.0 * time - 1.0);
  switch (sequence.motion) {
    case BallMotion::kRoll:
      return {{along, 0, 0}, along / sequence.axes.z()};
    case BallMotion::kLift:
      return {{along, 0, kLiftHeight * std::sin(M_PI * time)}, 2.0 * time};
    case BallMotion::kApproach:
      return {{0, -along, 0}, 0.0};
    default:
      return {};
  }
}

/// Returns the pose of the ball, turned about y through its centre, which stays above the foot, and
/// lifted so that the ball touches the table again.
Eigen::Isometry3d pose_of(const BallPlace& place, const Vector3d& axes) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() = Eigen::AngleAxisd(place.turn, Vector3d::UnitY()).toRotationMatrix();
  const double height = axes.cwiseProduct(X.linear().row(2).transpose()).norm();
  const Vector3d centre = place.foot + Vector3d(0, 0, height);
  X.translation() = centre - X.linear() * Vector3d(0, 0, axes.z());
  return X;
}

Eigen::Isometry3d camera_at(const GeneratedSequence& sequence, double time) {
  const double circling = sequence.motion == BallMotion::kOrbit ? 1.0 : 0.0;
  const double angle = circling * kCircle * (2.0 * time - 1.0);
  const double cosine = std::sqrt(1.0 - kElevation * kElevation);
  const Vector3d forward(cosine * std::sin(angle), cosine * std::cos(angle), -kElevation);
  const Vector3d right(std::cos(angle), -std::sin(angle), 0.0);
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
  X_WC.linear() << right, forward.cross(right), forward;
  X_WC.translation() = Vector3d(0, 0, sequence.axes.z()) - sequence.distance * forward;
  return X_WC.inverse();
}

/// Removes bodies that stand where the ball will pass.
void clear_the_way(const GeneratedSequence& sequence, std::vector<scene::Body>* bodies) {
  std::erase_if(*bodies, [&](const scene::Body& body) {
    // Table and wall have no footprint, and stay.
    if (body.reach == 0.0) return false;
    for (int k = 0; k <= 20; ++k) {
      const Vector3d foot = place_at(sequence, k / 20.0).foot;
      const double gap = (body.X_WB.translation() - foot).head<2>().norm();
      if (gap < body.reach + sequence.axes.maxCoeff()) return true;
    }
    return false;
  });
}

/// Puts a box in front of the middle of the path, to one side.
void hide(const GeneratedSequence& sequence, scene::Random* random, scene::Layout* layout) {
  const double size = sequence.axes.maxCoeff();
  scene::Body box = scene::random_box(size / 0.08, random);
  const double way = sequence.motion == BallMotion::kApproach ? kReach : 0.0;
  box.X_WB.translation() << 0.8 * size, -(way + size + box.reach), 0.0;
  layout->bodies.push_back(box);
}

}  // namespace

const std::vector<GeneratedSequence>& ball_sequences() {
  using M = BallMotion;
  static const std::vector<GeneratedSequence> all = {
      {"Pilates Ball 1", {.13, .13, .13}, M::kRoll, 1.2, true, false, 94.4},
      {"Rugby Ball", {.14, .095, .095}, M::kLift, 1.2, false, false, 100.0},
      {"Pilates Ball 2", {.275, .275, .275}, M::kRoll, 2.0, true, true, 100.0},
      {"Big Globe", {.15, .15, .15}, M::kOrbit, 1.8, true, true, 90.7},
      {"Small Globe", {.06, .06, .06}, M::kOrbit, 1.6, true, true, 56.9},
      {"Apple", {.04, .04, .04}, M::kLift, 1.0, true, true, 99.6},
      {"Football", {.11, .11, .11}, M::kApproach, 1.6, true, true, 100.0},
      {"Orange Ball", {.05, .05, .05}, M::kRoll, 1.2, true, true, 93.3},
  };
  return all;
}

BallFrameScene ball_scene(const GeneratedSequence& sequence, double time, std::uint64_t seed) {
  BallFrameScene frame;
  scene::Scene& made = frame.made;
  made.options.family = scene::Family::kMedium;
  const scene::FamilyTraits& traits = scene::traits_of(made.options.family);
  scene::Random clutter(seed, 0);
  made.layout = scene::find_layout(traits, &clutter);
  clear_the_way(sequence, &made.layout.bodies);
  if (sequence.hidden) hide(sequence, &clutter, &made.layout);
  scene::Body ball = scene::make_ball(sequence.axes);
  ball.X_WB = pose_of(place_at(sequence, time), sequence.axes);
  made.layout.X_CW = camera_at(sequence, time);
  frame.centre_C = made.layout.X_CW * ball.X_WB * Vector3d(0, 0, sequence.axes.z());
  // The ball is the last body, so its surface comes last.
  made.layout.bodies.push_back(ball);
  made.ideal = scene::render(made.camera, made.layout.bodies, made.layout.X_CW);
  scene::Random pixels(seed, 1 + static_cast<std::uint64_t>(1e6 * time));
  made.view = scene::observe(made.camera, made.ideal, traits, &pixels);
  frame.seen =
      static_cast<double>(made.ideal.visible.back()) / std::max(1, made.ideal.alone.back());
  return frame;
}

bool is_ball(const Detection& found, const Vector3d& centre_C, Vector3d axes, double share) {
  const bool sphere = found.type == QuadricType::kSphere;
  if (!sphere && found.type != QuadricType::kEllipsoid) return false;
  Vector3d sizes = Vector3d::Constant(found.dimensions.front().value);
  for (int k = 0; !sphere && k < 3; ++k) {
    sizes[k] = found.dimensions[static_cast<std::size_t>(k)].value;
  }
  std::sort(sizes.data(), sizes.data() + 3);
  std::sort(axes.data(), axes.data() + 3);
  const double most = share * 2.0 * axes[2];
  return (found.X_CQ.translation() - centre_C).norm() <= most &&
         (sizes - axes).cwiseAbs().maxCoeff() <= most;
}

}  // namespace quadrille::experiments
