#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "lab/experiments/experiments.hpp"
#include "lab/experiments/measure.hpp"
#include "lab/scene/bodies.hpp"
#include "lab/scene/scene.hpp"
#include "lab/scoring/score.hpp"
#include "quadrille/detector/detector.hpp"

namespace quadrille::experiments {
namespace {

using Eigen::Vector3d;

constexpr int kArrangements = 7;

/// An object around which scenes are built.
struct SceneObject {
  const char* name;
  scene::Body body;
  /// Whether the object lies on its side in every other scene.
  bool lies;
};

/// Makes a body of one curved surface in its own frame.
scene::Body shell(const std::string& type, const Vector10d& q, const Eigen::AlignedBox3d& box) {
  scene::Body body{type, {}, {}, Eigen::Isometry3d::Identity(), box.max().head<2>().norm()};
  body.surfaces.push_back({type, true, Quadric(q), box, {}, {}});
  body.X_BS.push_back(Eigen::Isometry3d::Identity());
  return body;
}

/// Makes an arched sheet of paper: z = h − x²/4f.
scene::Body bent_paper() {
  constexpr double kHeight = 0.06, kHalfWidth = 0.09, kHalfLength = 0.13;
  Vector10d q = Vector10d::Zero();
  q[0] = kHeight / (kHalfWidth * kHalfWidth), q[8] = 0.5, q[9] = -kHeight;
  return shell(
      "parabolic_cylinder", q,
      {Vector3d(-kHalfWidth, -kHalfLength, 0), Vector3d(kHalfWidth, kHalfLength, kHeight)});
}

/// Makes the upper half of an ellipsoid.
scene::Body helmet() {
  const Vector3d axes(0.13, 0.1, 0.12);
  Vector10d q = Vector10d::Zero();
  q.head<3>() = axes.cwiseAbs2().cwiseInverse();
  q[9] = -1.0;
  return shell("ellipsoid", q, {Vector3d(-axes.x(), -axes.y(), 0), axes});
}

/// Returns the four objects that the paper names, and a fifth that it does not.
std::vector<SceneObject> scene_objects() {
  return {{"bent paper", bent_paper(), false},
          {"helmet", helmet(), false},
          {"paper towel", scene::make_cylinder(0.055, 0.24), true},
          {"spray bottle", scene::make_cylinder(0.03, 0.2), true},
          {"ball", scene::make_ball({0.08, 0.08, 0.08}), false}};
}

/// Returns the pose of the object on the table, turned about z. Objects that may lie are laid on
/// their side in every other arrangement.
Eigen::Isometry3d object_pose(const SceneObject& object, int arrangement) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() = Eigen::AngleAxisd(0.9 * arrangement, Vector3d::UnitZ()).toRotationMatrix();
  if (!object.lies || arrangement % 2 == 0) return X;
  const double radius = object.body.surfaces.front().dims.front().second;
  const double length = object.body.surfaces.front().dims.back().second;
  X = X * Eigen::Translation3d(0, 0.5 * length, radius) *
      Eigen::AngleAxisd(0.5 * M_PI, Vector3d::UnitX());
  return X;
}

/// A scene in which only the object has to be found, and the visible share of its pixels.
struct ObjectScene {
  scoring::Frame frame;
  double seen;
};

/// Makes a scene with the object in the middle of other things.
ObjectScene object_scene(const SceneObject& object, int arrangement, std::uint64_t seed) {
  scene::Scene made;
  made.options = {scene::Family::kHard, seed};
  const scene::FamilyTraits& traits = scene::traits_of(made.options.family);
  scene::Random clutter(seed, 0), pixels(seed, 1);
  made.layout = scene::find_layout(traits, &clutter);
  scene::Body body = object.body;
  body.X_WB = object_pose(object, arrangement);
  const double room = std::max(body.reach, object.lies ? 0.13 : 0.0);
  std::erase_if(made.layout.bodies, [&](const scene::Body& other) {
    const double away = other.X_WB.translation().head<2>().norm();
    return other.reach > 0.0 && away < other.reach + room;
  });
  const int count = static_cast<int>(scene::count_quadrics(made));
  made.layout.bodies.push_back(body);
  made.ideal = scene::render(made.camera, made.layout.bodies, made.layout.X_CW);
  made.view = scene::observe(made.camera, made.ideal, traits, &pixels);
  scoring::Frame frame = scoring::frame_of(made);
  int curved = 0;
  for (scoring::TrueSurface& surface : frame.surfaces) {
    if (surface.curved) surface.evaluate = curved++ >= count;
  }
  const auto at = made.ideal.alone.size() - body.surfaces.size();
  return {frame, static_cast<double>(made.ideal.visible[at]) / std::max(1, made.ideal.alone[at])};
}

}  // namespace

Report run_objects(const Settings& settings) {
  const int arrangements = settings.quick ? 2 : kArrangements;
  const std::vector<SceneObject> objects = scene_objects();
  Report report;
  report.data.columns = {"object", "arrangement", "asked", "found", "seen", "ms"};
  Table table{"Scenes of five objects in clutter", {"object", "scenes", "least seen", "found"}, {}};
  int found = 0, asked = 0;
  for (std::size_t k = 0; k < objects.size(); ++k) {
    scoring::FrameScore score;
    double least = 1.0;
    for (int a = 0; a < arrangements; ++a) {
      const std::uint64_t seed = settings.seed * 1000 + 10 * k + static_cast<std::uint64_t>(a);
      const ObjectScene made = object_scene(objects[k], a, seed);
      DetectionResult result;
      const double us = microseconds([&] { result = detect(made.frame.cloud); });
      const scoring::FrameScore one = scoring::score(made.frame, scoring::findings_of(result));
      report.data.row(objects[k].name, a, one.wanted, one.found, made.seen, 1e-3 * us);
      score += one;
      least = std::min(least, made.seen);
      settings.progress((static_cast<double>(k) + (a + 1.0) / arrangements) /
                        static_cast<double>(objects.size()));
    }
    found += score.found, asked += score.wanted;
    table.row(objects[k].name, score.wanted, fmt::format("{:.0f} %", 100.0 * least), score.found);
  }
  report.findings = {
      fmt::format("{} of {} objects are found, by any quadric that runs along "
                  "their surface, one in each scene.",
                  found, asked)};
  report.tables = {table};
  return report;
}

}  // namespace quadrille::experiments
