#include "search/axes/axis_votes.hpp"

#include "detector/search/axes/bottle.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("the normal lines of a standing bottle vote for its axis", "[search][axes]") {
  const Eigen::Isometry3d X_CB = some_pose();
  const Eigen::Vector3d up = X_CB.linear().col(2);
  struct Case {
    double noise, tilt;
    int outliers;
    double limit;
  };
  // With exact normals only the cells of the votes blur the axis. Of 2,000 outliers the box of the
  // bottle has as many as the bottle has samples.
  for (const Case& c :
       {Case{0.0, 0.0, 0, 1e-4}, Case{0.001, 0.1, 0, 1.5e-3}, Case{0.001, 0.1, 2000, 2.5e-3}}) {
    SurfaceSamples samples = bottle(X_CB, c.noise, c.tilt);
    add_outliers(&samples, X_CB, c.outliers);
    const std::vector<Axis> axes = vote_for_axes(samples, {}, up, 60);
    REQUIRE_FALSE(axes.empty());
    CAPTURE(c.noise, c.outliers);
    CHECK(off_axis(X_CB, axes[0].point) < c.limit);
    CHECK(axes[0].direction == up);
  }
}

TEST_CASE("a table has no axis, and neither have few samples or none", "[search][axes]") {
  CHECK(vote_for_axes({}, {}, Eigen::Vector3d::UnitZ(), 60).empty());
  SurfaceSamples table;
  for (int i = 0; i < 400; ++i) {
    add_sample(&table, Eigen::Vector3f(0.003f * (i % 20), 0.003f * (i / 20), 1.0f),
               Eigen::Vector3f::UnitZ());
  }
  CHECK(vote_for_axes(table, {}, Eigen::Vector3d::UnitZ(), 60).empty());
  SurfaceSamples few;
  for (int i = 0; i < 5; ++i)
    add_sample(&few, Eigen::Vector3f(0.01f * i, 0, 1), Eigen::Vector3f::UnitX());
  CHECK(vote_for_axes(few, {}, Eigen::Vector3d::UnitZ(), 60).empty());
}

TEST_CASE("only open samples vote, and the number of axes is limited", "[search][axes]") {
  const Eigen::Isometry3d X_CB = some_pose();
  SurfaceSamples samples = bottle(X_CB, 0.0, 0.0);
  const auto count = static_cast<std::size_t>(samples.size());
  add_outliers(&samples, X_CB, 2000);
  Mask open(static_cast<std::size_t>(samples.size()), 0);
  std::fill_n(open.begin(), count, char{1});
  const Eigen::Vector3d up = X_CB.linear().col(2);
  CHECK(off_axis(X_CB, vote_for_axes(samples, open, up, 60).at(0).point) < 1e-4);
  CHECK(vote_for_axes(samples, {}, up, 3).size() == 3);
  CHECK(vote_for_axes(samples, Mask(open.size(), 0), up, 60).empty());
}

TEST_CASE("things kilometres away cost no memory and hide nothing", "[search][axes]") {
  const Eigen::Isometry3d X_CB = some_pose();
  SurfaceSamples samples = bottle(X_CB, 0.0, 0.0);
  add_sample(&samples, Eigen::Vector3f(5e3f, 0, 0), Eigen::Vector3f::UnitY());
  const std::vector<Axis> axes = vote_for_axes(samples, {}, X_CB.linear().col(2), 60);
  REQUIRE_FALSE(axes.empty());
  CHECK(off_axis(X_CB, axes[0].point) < 1e-4);
}
