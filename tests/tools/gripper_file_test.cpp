#include "io/planner/gripper_file.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;
using test::contains;
using test::error_of;

namespace {

const std::string kGripper =
    "name = \"pinch\"\nmax_opening = 0.1\nmin_opening = 0.0\nfinger = [0.02, 0.015, 0.05]\n"
    "finger_front = 0.01\npad = [0.02, 0.02]\npalm = [0.06, 0.2, 0.06]\nmax_force = 70\n";

std::string gripper_error(const std::string& text) {
  const test::TempFolder folder;
  return error_of([&] { io::read_gripper(folder.write("g.toml", text)); });
}

using Fields = std::pair<std::string, std::vector<double>>;

/// All that a file says of a hand.
Fields fields_of(const Gripper& g) {
  return {g.name,
          {g.max_opening, g.min_opening, g.finger.x(), g.finger.y(), g.finger.z(), g.finger_front,
           g.pad.x(), g.pad.y(), g.palm.x(), g.palm.y(), g.palm.z(), g.max_force, g.link_length,
           g.link_angle, g.tcp}};
}

}  // namespace

TEST_CASE("a gripper is read from its file", "[gripper]") {
  const test::TempFolder folder;
  const Gripper gripper = io::load_gripper(folder.write("g.toml", kGripper));
  CHECK(gripper.name == "pinch");
  CHECK(gripper.max_opening == 0.1);
  CHECK(gripper.finger == Eigen::Vector3d(0.02, 0.015, 0.05));
  CHECK(gripper.pad == Eigen::Vector2d(0.02, 0.02));
  CHECK(gripper.palm == Eigen::Vector3d(0.06, 0.2, 0.06));
  CHECK(gripper.finger_front == 0.01);
  CHECK(gripper.max_force == 70.0);
}

TEST_CASE("what is written of a gripper is read back the same", "[gripper]") {
  const test::TempFolder folder;
  for (const std::string& name : io::gripper_names()) {
    CAPTURE(name);
    const Gripper gripper = io::load_gripper(name);
    const Gripper back = io::read_gripper(folder.write("g.toml", io::to_toml(gripper)));
    CHECK(fields_of(back) == fields_of(gripper));
  }
}

TEST_CASE("the Robotiq hands are known by name, with links that close them", "[gripper]") {
  const Gripper small = io::load_gripper("robotiq_2f85");
  CHECK(small.max_opening == 0.085);
  CHECK(small.extension(0.0) == Approx(0.0139).margin(3e-4));
  const Gripper large = io::load_gripper("robotiq_2f140");
  CHECK(large.max_opening == 0.1285);
  CHECK(large.extension(0.0) == Approx(0.0237).margin(3e-4));
  CHECK(contains(error_of([] { io::load_gripper("claw"); }),
                 "known: franka, robotiq_2f140, robotiq_2f85, wsg50"));
}

TEST_CASE("a contradiction in a gripper file is one line with file, field and remedy",
          "[gripper][hostile]") {
  const test::TempFolder folder;
  std::string text = kGripper;
  text.replace(text.find("max_opening = 0.1"), 17, "max_opening = 0.0");
  const std::string path = folder.write("g.toml", text);
  const std::string error = error_of([&] { io::load_gripper(path); });
  CHECK(contains(error, path));
  CHECK(contains(error, "max_opening must be positive; measure it on the hand"));
  CHECK_FALSE(contains(error, "\n"));
  CHECK(contains(gripper_error(kGripper + "link_angle = 0.5\n"), "link_length is missing"));
  CHECK(contains(gripper_error(kGripper + "tcp = \"far\"\n"), "'tcp' must be a number"));
}

TEST_CASE("a wrong gripper file is refused with its key", "[gripper][hostile]") {
  CHECK(gripper_error(kGripper).empty());
  CHECK(contains(gripper_error(kGripper + "thumb = 1\n"), "line 9: unknown key 'thumb'"));
  CHECK(contains(gripper_error("max_opening = 0.1\n"), "'min_opening' is missing"));
  CHECK(contains(gripper_error("max_opening = \"wide\"\n"), "line 1: key 'max_opening'"));
  std::string two = kGripper;
  two.replace(two.find("[0.02, 0.015, 0.05]"), 19, "[0.02, 0.015]");
  CHECK(contains(gripper_error(two), "line 4: key 'finger'"));
}

TEST_CASE("the library's own hands are files too, with the same numbers", "[gripper]") {
  for (const Gripper& expected : {franka_hand(), schunk_wsg50(), robotiq_2f85(), robotiq_2f140()}) {
    INFO(expected.name);
    const Gripper hand = io::load_gripper(expected.name);
    CHECK(fields_of(hand) == fields_of(expected));
    CHECK(contains(io::gripper_toml(expected.name), "name = \"" + expected.name + "\""));
  }
}

TEST_CASE("each built-in hand is printed as a file that reads back to the same numbers",
          "[gripper][command]") {
  const test::TempFolder folder;
  const test::Run list = test::run_quadrille("gripper");
  CHECK(list.code == 0);
  for (const char* name : {"franka", "robotiq_2f140", "robotiq_2f85", "wsg50"}) {
    INFO(name);
    CHECK(contains("\n" + list.out, "\n" + std::string(name) + " "));
    const test::Run printed = test::run_quadrille("gripper " + std::string(name));
    REQUIRE(printed.code == 0);
    const Gripper back = io::read_gripper(folder.write("mine.toml", printed.out));
    CHECK(fields_of(back) == fields_of(io::load_gripper(name)));
  }
  CHECK(test::lines_of(list.out) == 4);
  const test::Run unknown = test::run_quadrille("gripper claw");
  CHECK(unknown.code == 2);
  CHECK(contains(unknown.err, "known: franka, robotiq_2f140, robotiq_2f85, wsg50"));
}
