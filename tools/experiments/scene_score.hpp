#pragma once

#include <vector>

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "scene/scene.hpp"

namespace quadrille::experiments {

/// A surface of which fewer pixels are seen is all but hidden.
inline constexpr int kLeastPixels = 300;

/// The points of a scene's view.
PointCloud cloud_of(const scene::Scene& made);

/// How much of one scene or of several was found; curved surfaces alone.
struct SceneScore {
  /// Surfaces of which kLeastPixels are seen, and those that a detection matches.
  int known = 0, found = 0;
  /// Detections of curved types, and those of them that match a curved surface.
  int detected = 0, right = 0;

  SceneScore& operator+=(const SceneScore& other);
  double recall() const { return known ? static_cast<double>(found) / known : 1.0; }
  double precision() const { return detected ? static_cast<double>(right) / detected : 1.0; }
};

/// A surface of a scene and the points that tell who found it.
struct KnownSurface {
  /// Counted over all bodies, as the scene's labels are.
  int id = 0;
  bool curved = false;
  /// How many see it.
  int pixels = 0;
  /// Of the distance from a quadric [m].
  double tolerance = 0.0;
  /// Indices of some of its points, and of some of those within its box.
  std::vector<int> own, near;
};

/// What is there to be found in a scene.
///
/// A detection matches a surface when 60 % of the surface's points lie on it, and half of the
/// points that lie on it within the surface's box are the surface's: nearer than
/// max(2σ, min(2 % of the size, 10 mm)) with its gradient within 20° of the true normal. Planes
/// match planes, all others curved surfaces. Best score first, each takes the surface that it
/// covers most of; each surface is taken once.
class SceneTruth {
 public:
  /// @param made   must outlive this
  /// @param noise  factor on the depth noise that the scene was observed with
  SceneTruth(const scene::Scene& made, double noise);
  explicit SceneTruth(const scene::Scene& made)
      : SceneTruth(made, scene::traits_of(made.options.family).noise) {}

  /// For each detection the id of the surface that it matches, or -1.
  std::vector<int> matches(const DetectionResult& result) const;
  SceneScore score(const DetectionResult& result) const;

 private:
  const scene::View& view_;
  std::vector<KnownSurface> surfaces_;
};

}  // namespace quadrille::experiments
