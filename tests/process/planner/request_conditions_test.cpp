// What a request may ask of the grasps: places, reach, numbers, a deadline.
#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "process/planner/asked_planner.hpp"
#include "quadrille/bus/bodies_message.hpp"
#include "quadrille/bus/body_tracks_message.hpp"
#include "support/temp_folder.hpp"

namespace quadrille {
namespace {

using namespace test;

TEST_CASE("a request may bring a number of grasps of each target, and a score",
          "[process][request]") {
  Asked asked("--on-request --per-target 2 --min-score 0");
  asked.show(1000);
  const auto most_of_one = [](const grasps_t& answer) {
    std::map<int, int> counts;
    int most = 0;
    for (const grasp_t& grasp : answer.grasps) most = std::max(most, ++counts[grasp.target]);
    return most;
  };
  CHECK(most_of_one(asked.ask(request_of(1))) == 2);
  grasp_request_t request = request_of(2);
  request.per_target = 5;
  CHECK(most_of_one(asked.ask(request)) == 5);
  request.request_id = 3;
  request.min_score = asked.answers.back().grasps.front().score;
  const grasps_t good = asked.ask(request);
  REQUIRE_FALSE(good.grasps.empty());
  for (const grasp_t& grasp : good.grasps) CHECK(grasp.score >= request.min_score);
  request.min_score = 1.5;
  CHECK(asked.ask(request).warnings.back() == "min_score = 1.5: must be 0 to 1");
  request.min_score = 0.0;
  request.per_target = -1;
  CHECK(asked.ask(request).warnings.back() == "per_target = -1: must be 0 or more");
}

TEST_CASE("a request may ask what would give grasps to targets that have none",
          "[process][request][remedies]") {
  Asked asked("--on-request");
  asked.show(1000);
  grasp_request_t request = request_of(1);
  request.min_score = 1.0;
  CHECK(asked.ask(request).remedies.empty());
  request.advise = 1;
  const grasps_t advised = asked.ask(request);
  CHECK(advised.grasps.empty());
  REQUIRE_FALSE(advised.remedies.empty());
  const remedy_t& first = advised.remedies.front();
  REQUIRE(first.change.starts_with("--min-score "));
  // With the score that the remedy names there are as many grasps as it says.
  request.targets = {first.target};
  request.num_targets = 1;
  request.min_score = std::stod(first.change.substr(12));
  const grasps_t followed = asked.ask(request);
  CHECK(followed.remedies.empty());
  CHECK(followed.num_grasps == first.num_grasps);
  CHECK(followed.grasps.front().score == Approx(first.score));
}

TEST_CASE("a request may ask for a body by its track", "[process][request][track]") {
  Asked asked("--on-request");
  std::vector<SceneBody> bodies = asked_found().bodies;
  for (SceneBody& body : bodies) body.track = 100 + body.id;
  const bus::CloudMessage cloud{1000, 0, asked_cloud()};
  asked.give("BODIES", bus::encode(bus::to_message(cloud, bodies)));
  asked.give("BODY_TRACKS", bus::encode(bus::tracks_message(cloud, bodies)));
  asked.show(1000);
  const auto holds_sphere = [](const SceneBody& body) {
    return std::find(body.parts.begin(), body.parts.end(), a_sphere().id) != body.parts.end();
  };
  const auto ball = std::find_if(bodies.begin(), bodies.end(), holds_sphere);
  REQUIRE(ball != bodies.end());
  grasp_request_t request = request_of(1);
  request.tracks = {ball->track};
  request.num_tracks = 1;
  CHECK(targets_of(asked.ask(request)) == std::set{a_sphere().id});
  // Without their message bodies have no track.
  asked.give("BODIES", bus::encode(bus::to_message({2000, 0, asked_cloud()}, bodies)));
  asked.show(2000);
  CHECK(asked.ask(request).grasps.empty());
}

TEST_CASE("a request may ask for views that would help bodies without a sure grasp",
          "[process][request][looks]") {
  const Eigen::Isometry3d X_WK =
      Eigen::Translation3d(1.0, -0.5, 0.75) * Eigen::Quaterniond(0.5, 0.5, -0.5, 0.5);
  // A hand that comes from one metre above crosses space that the camera did not see.
  const TempFolder folder;
  const std::string cautious =
      " --config " + folder.write("p.toml",
                                  "[planner]\nunknown = \"obstacle\"\nclear_above = false\n"
                                  "approach = 1.0\n");
  Asked asked("--on-request --result-frame world --camera-pose=1,-0.5,0.75,0.5,0.5,-0.5,0.5" +
              cautious);
  const std::vector<SceneBody>& bodies = asked_found().bodies;
  asked.give("BODIES", bus::encode(bus::to_message({1000, 0, asked_cloud()}, bodies)));
  asked.show(1000);
  grasp_request_t request = request_of(1);
  CHECK(asked.ask(request).looks.empty());
  request.advise = 1;
  const grasps_t advised = asked.ask(request);
  CHECK(advised.frame == "world");
  REQUIRE_FALSE(advised.looks.empty());
  double before = advised.looks.front().gain;
  for (const look_t& look : advised.looks) {
    CHECK(look.gain > 0.0);
    CHECK(look.gain <= before);
    before = look.gain;
    REQUIRE_FALSE(look.bodies.empty());
    // The camera sees the bodies that it helps.
    const Eigen::Isometry3d X_WL = bus::from_message(look.pose);
    CHECK(std::all_of(look.bodies.begin(), look.bodies.end(), [&](int id) {
      const auto body = std::find_if(bodies.begin(), bodies.end(),
                                     [&](const SceneBody& other) { return other.id == id; });
      if (body == bodies.end()) return false;
      const Eigen::Vector3d p_L = X_WL.inverse() * X_WK * body->X_CB.translation();
      return p_L.z() > 0.3 && p_L.head<2>().norm() < 0.5 * p_L.z();
    }));
  }
  // No view is proposed for bodies that were not asked for.
  request.targets = {a_sphere().id};
  request.num_targets = 1;
  const grasps_t one = asked.ask(request);
  REQUIRE(one.looks.size() == 1);
  CHECK(one.looks[0].bodies == std::vector<std::int32_t>{a_sphere().id});
}

TEST_CASE("an arm's reach may be in any frame that is known, and wins over that of the settings",
          "[process][request][reach]") {
  const Eigen::Isometry3d X_WK =
      Eigen::Translation3d(1.0, -0.5, 0.75) * Eigen::Quaterniond(0.5, 0.5, -0.5, 0.5);
  const Eigen::Vector3d p_K = a_sphere().X_CQ.translation(), p_W = X_WK * p_K;
  const std::string pose = "--on-request --camera-pose=1,-0.5,0.75,0.5,0.5,-0.5,0.5 ";
  // By the settings nothing is within reach.
  Asked asked(pose + "--reach=9,9,9,0,1");
  asked.show(1000);
  const grasps_t none = asked.ask(request_of(1));
  CHECK(none.grasps.empty());
  CHECK(std::any_of(none.rejected.begin(), none.rejected.end(),
                    [](const count_t& entry) { return entry.name == "reach"; }));
  // No approach is longer than 10 cm, and nothing else is so near the sphere.
  for (const std::string frame : {"", "eye", "camera", "world"}) {
    CAPTURE(frame);
    grasp_request_t request = request_of(1);
    request.frame = frame;
    request.has_reach = 1;
    Eigen::Map<Eigen::Vector3d>(request.reach_base) = frame == "world" ? p_W : p_K;
    request.reach_max = 0.1;
    CHECK(targets_of(asked.ask(request)) == std::set{a_sphere().id});
  }
  // By these settings it is the sphere that is.
  Asked near(pose + "--reach=" + std::to_string(p_W.x()) + "," + std::to_string(p_W.y()) + "," +
             std::to_string(p_W.z()) + ",0,0.1");
  near.show(1000);
  CHECK(targets_of(near.ask(request_of(1))) == std::set{a_sphere().id});
  // Without a fixed frame the settings are in the camera's.
  Asked unplaced("--on-request --reach=" + std::to_string(p_K.x()) + "," + std::to_string(p_K.y()) +
                 "," + std::to_string(p_K.z()) + ",0,0.1");
  unplaced.show(1000);
  CHECK(targets_of(unplaced.ask(request_of(1))) == std::set{a_sphere().id});
  grasp_request_t request = request_of(9);
  request.has_reach = 1;
  CHECK(unplaced.ask(request).warnings.back().find("reach's greatest distance = 0: must be") == 0);
}

TEST_CASE("a request may bring a deadline of its own", "[process][request][deadline]") {
  Asked asked("--on-request");
  asked.show(1000);
  grasp_request_t hasty = request_of(1);
  hasty.deadline_ms = 1e-6;
  const grasps_t cut = asked.ask(hasty);
  CHECK(cut.grasps.empty());
  CHECK(std::any_of(cut.rejected.begin(), cut.rejected.end(),
                    [](const count_t& entry) { return entry.name == "deadline"; }));
  CHECK(asked.status().cut == 1);
  // The next one gets all, though the scene of the last one lacked its targets, and so does the one
  // after it, on the scene that is kept: a deadline is for one request alone.
  CHECK(targets_of(asked.ask(request_of(2))).size() >= 3);
  hasty.request_id = 3;
  CHECK(asked.ask(hasty).grasps.empty());
  CHECK(targets_of(asked.ask(request_of(4))).size() >= 3);
  CHECK(asked.status().cut == 2);
}

TEST_CASE("places in a request may be in any frame that is known", "[process][request]") {
  const Eigen::Isometry3d X_WK =
      Eigen::Translation3d(1.0, -0.5, 0.75) * Eigen::Quaterniond(0.5, 0.5, -0.5, 0.5);
  Asked asked("--on-request --camera-pose=1,-0.5,0.75,0.5,0.5,-0.5,0.5");
  asked.show(1000);
  const Eigen::Vector3d p_K = a_sphere().X_CQ.translation(), p_W = X_WK * p_K;
  for (const std::string frame : {"", "eye", "camera", "world"}) {
    CAPTURE(frame);
    grasp_request_t request = request_of(1);
    request.frame = frame;
    request.has_near = 1;
    Eigen::Map<Eigen::Vector3d>(request.near) = frame == "world" ? p_W : p_K;
    CHECK(targets_of(asked.ask(request)) == std::set{a_sphere().id});
    // A slim box about it, turned about its middle.
    request.has_near = 0;
    request.has_region = 1;
    std::copy_n(request.near, 3, request.region.position);
    const double q[] = {0.8, 0.0, 0.6, 0.0};
    std::copy_n(q, 4, request.region.quaternion);
    std::fill_n(request.region_size, 3, 0.01);
    CHECK(targets_of(asked.ask(request)) == std::set{a_sphere().id});
  }
  Asked unplaced("--on-request");
  unplaced.show(1000);
  grasp_request_t request = request_of(1);
  request.frame = "world";
  CHECK(unplaced.ask(request).warnings.at(0).find("frame 'world' is not known: no pose") == 0);
  request.frame = "moon";
  CHECK(unplaced.ask(request).warnings.at(0).find("frame 'moon' is not known: name") == 0);
}

}  // namespace
}  // namespace quadrille
