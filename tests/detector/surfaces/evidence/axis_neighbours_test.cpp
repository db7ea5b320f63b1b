#include "surfaces/evidence/axis_neighbours.hpp"

#include "detector/search/axes/bottle.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("the normal lines of a bottle's wall and neck meet the axis of its shoulder",
          "[evidence][axes]") {
  const Eigen::Isometry3d X_CB = some_pose();
  SurfaceSamples samples = bottle(X_CB, 0.0, 0.0);
  std::vector<int> shoulder;
  int near = 0;
  for (int i = 0; i < samples.size(); ++i) {
    const double h = (X_CB.inverse() * samples.raw[static_cast<std::size_t>(i)].cast<double>()).z();
    if (h > 0.1 && h < 0.13) shoulder.push_back(i);
    // The shoulder's largest radius is 38.75 mm, and the neighbourhood reaches 1.5 times as far.
    const double reach = 1.5 * 0.03875;
    near += (h < 0.1 && h > 0.1015 - reach) || (h > 0.13 && h < 0.1285 + reach);
  }
  const double size = static_cast<double>(shoulder.size());
  const Axis axis{X_CB.translation(), X_CB.linear().col(2)};
  const AxisNeighbours exact = axis_neighbours(samples, SampleBlocks(samples), shoulder, axis);
  CHECK(exact.meet == Approx(near / size).epsilon(0.1));
  CHECK(exact.miss == 0.0);

  // About a parallel axis 30 mm aside most of the same lines miss.
  const Axis beside{axis.point + 0.03 * X_CB.linear().col(1), axis.direction};
  const AxisNeighbours off = axis_neighbours(samples, SampleBlocks(samples), shoulder, beside);
  CHECK(off.miss > 3.0 * off.meet);

  // Lids and tables, whose normals are parallel to the axis, count neither way; the faces of a box
  // beside it miss.
  const auto add = [&](const Eigen::Vector3f& p, const Eigen::Vector3f& n) {
    add_sample(&samples, X_CB.cast<float>() * p, X_CB.linear().cast<float>() * n);
  };
  for (int k = 0; k < 50; ++k) add({0.001f * k, 0.0f, 0.115f}, Eigen::Vector3f::UnitZ());
  for (int k = 0; k < 20; ++k) add({0.02f, 0.04f, 0.1f + 0.001f * k}, Eigen::Vector3f::UnitX());
  const AxisNeighbours boxed = axis_neighbours(samples, SampleBlocks(samples), shoulder, axis);
  CHECK(boxed.meet == exact.meet);
  CHECK(boxed.miss == Approx(20 / size));
}

TEST_CASE("a surface alone has no neighbours about its axis", "[evidence][axes]") {
  const Eigen::Isometry3d X_CB = some_pose();
  const SurfaceSamples samples = bottle(X_CB, 0.0, 0.0);
  std::vector<int> all(static_cast<std::size_t>(samples.size()));
  for (int i = 0; i < samples.size(); ++i) all[static_cast<std::size_t>(i)] = i;
  const AxisNeighbours none = axis_neighbours(samples, SampleBlocks(samples), all,
                                              {X_CB.translation(), X_CB.linear().col(2)});
  CHECK(none.meet == 0.0);
  CHECK(none.miss == 0.0);
}
