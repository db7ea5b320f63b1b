#include "view/scene/owners.hpp"

#include <cmath>

#include "support/catch.hpp"

using namespace quadrille;

TEST_CASE("no more points are shown than were asked for, and none that is missing",
          "[view][points]") {
  PointCloud cloud;
  cloud.width = 64;
  cloud.height = 48;
  for (int i = 0; i < 64 * 48; ++i) {
    const float z = i % 7 == 0 ? std::nanf("") : 1.0f;
    cloud.points.push_back({static_cast<float>(i % 64), static_cast<float>(i / 64), z});
  }
  const auto all = view::thin_out(cloud, 1000000);
  CHECK(all.size() == static_cast<std::size_t>(64 * 48 - (64 * 48 + 6) / 7));
  const auto few = view::thin_out(cloud, 800);
  CHECK(few.size() <= 800);
  CHECK(few.size() > 400);
  for (const Eigen::Vector3f& p : few) {
    CHECK(p.allFinite());
    CHECK(static_cast<int>(p.x()) % 2 == 0);
    CHECK(static_cast<int>(p.y()) % 2 == 0);
  }
}

TEST_CASE("each point belongs to the surface that it lies on", "[view][points]") {
  std::vector<Detection> balls;
  for (const double x : {0.0, 1.0}) {
    Detection d;
    Vector10d q;
    q << 1, 1, 1, 0, 0, 0, -x, 0, 0, x * x - 0.01;
    d.Q_C = Quadric(q).normalized();
    d.X_CQ = Eigen::Translation3d(x, 0, 0);
    d.extent_Q =
        Eigen::AlignedBox3d(Eigen::Vector3d::Constant(-0.1), Eigen::Vector3d::Constant(0.1));
    d.rms = 0.001;
    balls.push_back(d);
  }
  const auto owners =
      view::owners_of({{0.1f, 0, 0}, {1.0f, 0.1f, 0}, {0.5f, 0, 0}, {1.0f, 0, 0}}, balls);
  CHECK(owners == std::vector<std::uint8_t>{1, 2, 0, 0});
}

TEST_CASE("the points that are shown keep their own colours", "[view][points][colours]") {
  PointCloud cloud;
  for (int i = 0; i < 200; ++i) {
    cloud.points.push_back({i % 5 == 0 ? std::nanf("") : static_cast<float>(i), 0, 1});
    cloud.colours.push_back({static_cast<std::uint8_t>(i), 0, 7});
  }
  std::vector<Rgb> colours;
  const auto shown = view::thin_out(cloud, 100, &colours);
  REQUIRE(!shown.empty());
  REQUIRE(colours.size() == shown.size());
  for (std::size_t i = 0; i < shown.size(); ++i) {
    CHECK(colours[i] == Rgb{static_cast<std::uint8_t>(shown[i].x()), 0, 7});
  }
  cloud.colours.clear();
  colours.clear();
  view::thin_out(cloud, 100, &colours);
  CHECK(colours.empty());
}
