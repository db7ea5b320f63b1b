#include "surfaces/hidden_ends.hpp"

#include "support/catch.hpp"
#include "support/surface_grid.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// A cylinder of radius 4 cm and length 12 cm along y of the image, its front 1 m in front of the
/// eye; its frame Q has z along its axis.
struct Scene {
  SurfaceSamples samples = cylinder_grid(15, 31, 0.04, 0.004, 0.0, 1);
  Eigen::Isometry3d X_CQ = Eigen::Isometry3d::Identity();
  Eigen::AlignedBox3d extent_Q{Eigen::Vector3d(-0.04, -0.04, -0.06),
                               Eigen::Vector3d(0.04, 0.04, 0.06)};
  Sight sight;

  Scene() {
    // x of the grid's frame, which the surface faces, comes towards the eye.
    Eigen::Matrix3d R;
    R.col(0) = -Eigen::Vector3d::UnitZ();
    R.col(1) = Eigen::Vector3d::UnitX();
    R.col(2) = -Eigen::Vector3d::UnitY();
    X_CQ.linear() = R;
    X_CQ.translation() = Eigen::Vector3d(0, 0, 1.04);
    for (Eigen::Vector3f& p : samples.raw) p = (X_CQ * p.cast<double>()).cast<float>();
    sight.step = 0.004f;
    sight.width = sight.height = 100;
    sight.corner = Eigen::Array2f(-0.2f, -0.2f);
    sight.w.assign(100 * 100, 1.0f / 2.0f);
  }

  /// What is seen at that depth in the rows of the image from v on [tangents].
  void see(double depth, double from, double to) {
    for (int j = 0; j < sight.height; ++j) {
      const double v = sight.corner.y() + (j + 0.5) * sight.step;
      if (v < from || v > to) continue;
      for (int i = 0; i < sight.width; ++i) {
        sight.w[static_cast<std::size_t>(j * sight.width + i)] = static_cast<float>(1.0 / depth);
      }
    }
  }

  bool hidden() const {
    return hides_an_end({&sight, 1}, samples, all_of(samples), X_CQ, extent_Q);
  }
};

}  // namespace

TEST_CASE("an end with nothing but the wall behind is seen", "[hidden_ends]") {
  CHECK_FALSE(Scene().hidden());
}

TEST_CASE("an end behind something is hidden, on either side", "[hidden_ends]") {
  Scene below, above;
  below.see(0.8, 0.059, 0.2);
  above.see(0.8, -0.2, -0.059);
  CHECK(below.hidden());
  CHECK(above.hidden());
}

TEST_CASE("what a cylinder stands on does not hide its end", "[hidden_ends]") {
  Scene scene;
  // A table that comes towards the eye from where the cylinder meets it, seen from 45° above.
  for (double v = 0.06; v < 0.2; v += 0.004) scene.see(1.0 - (v - 0.06), v, v + 0.004);
  CHECK_FALSE(scene.hidden());
}

TEST_CASE("an end beyond the border of the image is hidden", "[hidden_ends]") {
  Scene scene;
  scene.sight.height = 65;  // The last row is at .06.
  scene.sight.w.resize(100 * 65);
  CHECK(scene.hidden());
}

TEST_CASE("an end that one of several views sees is not hidden", "[hidden_ends]") {
  Scene scene, other;
  scene.see(0.8, 0.059, 0.2);
  const std::vector<Sight> blind = {scene.sight, scene.sight}, seen = {scene.sight, other.sight};
  const std::vector<int> region = all_of(scene.samples);
  CHECK(hides_an_end(blind, scene.samples, region, scene.X_CQ, scene.extent_Q));
  CHECK_FALSE(hides_an_end(seen, scene.samples, region, scene.X_CQ, scene.extent_Q));
}

TEST_CASE("without cells each end counts as seen", "[hidden_ends]") {
  Scene scene;
  scene.sight = Sight{};
  CHECK_FALSE(scene.hidden());
}
