#include "view/live/camera_trail.hpp"

#include "support/catch.hpp"

using namespace quadrille;

namespace {

constexpr std::int64_t kSecond = 1000000;

/// Tells a trail that the camera is at x on the x axis.
void tell(view::CameraTrail& trail, std::int64_t utime, double x) {
  const Eigen::Isometry3d X_WC(Eigen::Translation3d(x, 0.0, 0.0));
  trail.add(bus::encode_pose({utime, X_WC}));
}

double x_at(const view::CameraTrail& trail, std::int64_t utime) {
  const auto X_WK = trail.at(utime);
  REQUIRE(X_WK);
  return X_WK->translation().x();
}

}  // namespace

TEST_CASE("a camera is between the poses around a cloud, or else at the newest one",
          "[view][poses]") {
  view::CameraTrail trail;
  CHECK_FALSE(trail.at(kSecond));
  CHECK(trail.explain(kSecond).find("no pose has come") != std::string::npos);
  tell(trail, 10 * kSecond, 1.0);
  tell(trail, 11 * kSecond, 2.0);
  CHECK(x_at(trail, 10 * kSecond + kSecond / 4) == Approx(1.25));
  CHECK(x_at(trail, 11 * kSecond + kSecond / 2) == Approx(2.0));
  CHECK_FALSE(trail.at(13 * kSecond));
  CHECK(trail.explain(13 * kSecond).find("2 s older") != std::string::npos);
}

TEST_CASE("the path of a camera keeps its last positions, and none of a camera at rest",
          "[view][poses]") {
  view::CameraTrail trail;
  for (int i = 0; i < 10; ++i) tell(trail, i, 1e-4 * i);
  CHECK(trail.path().size() == 1);
  const int count = 2 * static_cast<int>(view::CameraTrail::kMaxPath);
  for (int i = 1; i <= count; ++i) tell(trail, 100 + i, 0.01 * i);
  REQUIRE(trail.path().size() == view::CameraTrail::kMaxPath);
  CHECK(trail.path().back().x() == Approx(0.01 * count));
  CHECK(trail.path().front().x() ==
        Approx(0.01 * (count + 1 - static_cast<int>(view::CameraTrail::kMaxPath))));
}

TEST_CASE("a log that is played again begins the path anew", "[view][poses]") {
  view::CameraTrail trail;
  tell(trail, 10 * kSecond, 1.0);
  tell(trail, 11 * kSecond, 2.0);
  tell(trail, 5 * kSecond, 3.0);
  tell(trail, 6 * kSecond, 4.0);
  REQUIRE(trail.path().size() == 2);
  CHECK(trail.path().front().x() == 3.0);
  CHECK(x_at(trail, 5 * kSecond + kSecond / 2) == Approx(3.5));
}

TEST_CASE("damaged poses change nothing", "[view][poses][hostile]") {
  view::CameraTrail trail;
  trail.add(std::vector<std::byte>(100, std::byte{0xff}));
  CHECK(trail.path().empty());
  CHECK_FALSE(trail.at(0));
}
