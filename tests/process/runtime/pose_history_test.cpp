#include "process/runtime/pose_history.hpp"

#include "support/catch.hpp"

namespace quadrille {
namespace {

bus::PoseMessage pose_at(std::int64_t utime) {
  return {utime, Eigen::Isometry3d(Eigen::Translation3d(static_cast<double>(utime), 0, 0))};
}

double x_at(const PoseHistory& history, std::int64_t utime) {
  const auto pose = history.at(utime);
  return pose ? pose->X_WC.translation().x() : -1.0;
}

TEST_CASE("the pose of a cloud is the newest that is not newer", "[process][pose]") {
  PoseHistory history;
  CHECK_FALSE(history.at(5));
  for (const int utime : {10, 20, 20, 30}) history.add(pose_at(utime));
  CHECK_FALSE(history.at(9));
  CHECK(x_at(history, 10) == 10.0);
  CHECK(x_at(history, 29) == 20.0);
  CHECK(x_at(history, 1000) == 30.0);
}

TEST_CASE("poses before a step back in time are forgotten", "[process][pose]") {
  PoseHistory history;
  history.add(pose_at(100));
  history.add(pose_at(50));
  CHECK_FALSE(history.at(49));
  CHECK(x_at(history, 100) == 50.0);
}

TEST_CASE("only so many poses are kept", "[process][pose]") {
  PoseHistory history(3);
  for (int utime = 1; utime <= 10; ++utime) history.add(pose_at(utime));
  CHECK_FALSE(history.at(7));
  CHECK(x_at(history, 8) == 8.0);
}

}  // namespace
}  // namespace quadrille
