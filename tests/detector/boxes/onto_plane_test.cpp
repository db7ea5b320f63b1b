#include "boxes/onto_plane.hpp"

#include <cmath>

#include "base/random.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using Eigen::Vector3d;

namespace {

const Vector3d kSensor(0.1, -0.2, 0.05);

/// A cloud seen from kSensor: an image of a wall, or two walls around the eye that are no single
/// view.
PointCloud walls(bool single) {
  PointCloud cloud;
  cloud.viewpoint = kSensor;
  for (int j = 0; j < 40; ++j) {
    for (int i = 0; i < 40; ++i) {
      const Eigen::Vector3f p(0.02f * (i - 20), 0.02f * (j - 20), 1.0f);
      cloud.points.push_back(p);
      if (!single) cloud.points.push_back(-p);
    }
  }
  return cloud;
}

Face tilted_face() {
  Face face;
  face.n_C = Vector3d(0.3, -0.4, -1.0).normalized();
  face.offset = face.n_C.dot(Vector3d(0.0, 0.0, 1.2));
  return face;
}

}  // namespace

TEST_CASE("points move along their lines of sight onto the plane", "[boxes]") {
  const PointCloud cloud = walls(true);
  const DirectionIndex sight(cloud);
  REQUIRE(sight.single());
  const Face face = tilted_face();
  const OntoPlane onto_plane(face, sight);
  RandomStream random(3, 0);
  for (int k = 0; k < 200; ++k) {
    const Vector3d p(random.uniform() - 0.5, random.uniform() - 0.5, 0.8 + random.uniform());
    const Vector3d on = onto_plane(p);
    CHECK(std::abs(face.height(on)) < 1e-12);
    CHECK((on - kSensor).cross(p - kSensor).norm() < 1e-12);
    CHECK((on - kSensor).dot(p - kSensor) > 0.0);
    CHECK((onto_plane(on) - on).norm() < 1e-12);
  }
}

TEST_CASE("points move at right angles where the line of sight tells no place on the plane",
          "[boxes][degenerate]") {
  const PointCloud one = walls(true), several = walls(false);
  const DirectionIndex single(one), not_single(several);
  REQUIRE_FALSE(not_single.single());
  const Face face = tilted_face();
  const Vector3d foot = kSensor - face.height(kSensor) * face.n_C;
  const auto moves_straight = [&](const Vector3d& p, const DirectionIndex& sight) {
    return (OntoPlane(face, sight)(p) - (p - face.height(p) * face.n_C)).norm() < 1e-12;
  };
  // Lines of sight at angles to the plane just below and above the least one.
  const Vector3d along = face.n_C.unitOrthogonal(), down = (foot - kSensor).normalized();
  const double sine = std::sqrt(1.0 - kMinCosine * kMinCosine);
  CHECK(moves_straight(kSensor + sine * along + 0.99 * kMinCosine * down, single));
  CHECK_FALSE(moves_straight(kSensor + sine * along + 1.01 * kMinCosine * down, single));
  CHECK(moves_straight(kSensor, single));
  CHECK(moves_straight({0.1, 0.2, 0.9}, not_single));
}
