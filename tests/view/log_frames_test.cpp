#include "view/log/log_frames.hpp"

#include <atomic>
#include <stdexcept>
#include <thread>

#include "logs/cloud_log_writer.hpp"
#include "support/catch.hpp"
#include "support/robot_log.hpp"
#include "support/temp_folder.hpp"
#include "view/log/log_backend.hpp"

using namespace quadrille;

namespace {

std::string write_log(const test::TempFolder& folder, int clouds) {
  const std::string path = folder.path("clouds.lcm");
  logs::CloudLogWriter writer(path, {});
  for (int i = 0; i < clouds; ++i) {
    PointCloud cloud;
    cloud.points = {{static_cast<float>(i), 0, 1}};
    cloud.read = 1;
    writer.write(cloud);
  }
  writer.flush();
  return path;
}

}  // namespace

TEST_CASE("the clouds of a log come in any order", "[view][log]") {
  const test::TempFolder folder;
  view::LogFrames frames(write_log(folder, 6), "");
  REQUIRE(frames.utimes().size() == 6);
  CHECK(frames.utimes()[1] - frames.utimes()[0] == 100000);
  for (const std::size_t number : {0, 5, 2, 3, 3, 1, 4}) {
    const auto frame = frames.load(number);
    REQUIRE(frame);
    CHECK(frame->cloud.message.cloud.points.at(0).x() == static_cast<float>(number));
  }
  CHECK(!frames.load(6));
  CHECK_THROWS_AS(view::LogFrames(frames.path(), "OTHER"), std::runtime_error);
}

TEST_CASE("a cloud of a log comes with the robot's shapes that were told nearest in time",
          "[view][log][robot]") {
  const test::TempFolder folder;
  const std::string path = folder.path("robot.lcm");
  {
    test::RobotLog log(path);
    for (const std::int64_t utime : {10, 24, 40}) {
      log.show(utime);
      log.tell(utime + 2, 0.001 * static_cast<double>(utime));
    }
    log.tell_nonsense(50, 20);
  }
  view::LogFrames frames(path, "", 1.0, "ROBOT");
  CHECK(frames.robot_refusals().count == 1);
  CHECK(frames.load(0)->robot == nullptr);
  CHECK(frames.load(2)->robot->robot.padding == 0.024);
  CHECK(frames.load(1)->robot->robot.padding == 0.010);
  CHECK(view::LogFrames(path, "").load(2)->robot == nullptr);
}

TEST_CASE("each cloud is worked on once, however many ask for it", "[view][log]") {
  const test::TempFolder folder;
  std::atomic<int> worked{0};
  view::LogBackend backend(view::LogFrames(write_log(folder, 3), ""), {"franka", "wsg50"},
                           [&](view::LogFrame frame, const view::PlanChoice&) {
                             ++worked;
                             view::Scene scene;
                             scene.cloud = frame.cloud.message.cloud;
                             return scene;
                           });
  std::vector<std::thread> askers;
  for (int i = 0; i < 12; ++i)
    askers.emplace_back([&, i] { backend.frame(static_cast<std::size_t>(i % 3), {}); });
  for (std::thread& asker : askers) asker.join();
  CHECK(worked == 3);
  CHECK(backend.frame(1, {}) != nullptr);
  CHECK(backend.frame(3, {}) == nullptr);
  CHECK(worked == 3);
  CHECK(backend.frame(1, {"wsg50", "", 0.0}) != backend.frame(1, {"", "", 0.01}));
  CHECK(worked == 5);
}
