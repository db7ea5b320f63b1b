#include "doctor/check_poses.hpp"

#include <cmath>
#include <limits>

#include "datagrams.hpp"
#include "support/catch.hpp"

namespace quadrille::doctor {
namespace {

using test::kNow;

std::int64_t time_of(double seconds) { return kNow + std::llround(1e6 * seconds); }

/// Messages at a rate, each of which arrives some time after its own time, but before the end.
std::deque<Arrival> make_arrivals(double rate, double delay, double from = 0.0, double to = 3.0) {
  std::deque<Arrival> arrivals;
  for (int i = 0; from + i / rate + delay < to - 1e-9; ++i) {
    arrivals.push_back({time_of(from + i / rate), time_of(from + i / rate + delay)});
  }
  return arrivals;
}

/// Three seconds of poses, and of clouds at 10 Hz that lie 5 ms after a pose of 100 Hz and arrive
/// 1 ms later.
PoseArrivals make_heard(double rate = 100.0, double delay = 0.005) {
  PoseArrivals heard;
  heard.channel = "POSE";
  heard.poses = make_arrivals(rate, delay);
  heard.clouds = make_arrivals(10.0, 0.001, 0.005);
  heard.begin = time_of(0.0);
  heard.end = time_of(3.0);
  return heard;
}

void check_only(const PoseArrivals& heard, Verdict verdict, const std::string& what,
                const std::string& remedy) {
  const Findings findings = check_poses(heard);
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].verdict == verdict);
  CHECK(findings[0].check == "poses");
  CHECK(findings[0].what == what);
  CHECK(findings[0].remedy == remedy);
}

TEST_CASE("poses in order are told with their rate and how long clouds wait for them",
          "[doctor][pose]") {
  check_only(make_heard(), Verdict::kOk,
             "300 poses on POSE, 100.0 Hz; a cloud waits 9 ms for the pose after it (half of "
             "them), 9 ms at the most",
             "");
}

TEST_CASE("poses that come before their clouds are not waited for", "[doctor][pose]") {
  PoseArrivals heard = make_heard();
  for (Arrival& cloud : heard.clouds) cloud.at += 40'000;
  CHECK(check_poses(heard)[0].what.find("waits 0 ms for the pose after it (half of them), 0 ms") !=
        std::string::npos);
}

TEST_CASE("without clouds it is not known how long they wait for poses", "[doctor][pose]") {
  PoseArrivals heard = make_heard();
  heard.clouds.clear();
  check_only(heard, Verdict::kOk,
             "300 poses on POSE, 100.0 Hz; no cloud came between them, so how long clouds wait is "
             "not known",
             "");
}

TEST_CASE("no pose is a failure, and names the channels with some", "[doctor][pose]") {
  PoseArrivals heard = make_heard();
  heard.poses.clear();
  check_only(heard, Verdict::kFailed, "nobody sent one on POSE in 3.0 s",
             "start what sends the camera's poses, or lcm-logplayer; for a camera at rest give "
             "both processes --camera-pose instead of --pose-channel");
  heard.other_channels = {"CAMERA_POSE", "HAND_POSE"};
  check_only(heard, Verdict::kFailed, "none on POSE, but some on CAMERA_POSE, HAND_POSE",
             "quadrille-detector --pose-channel CAMERA_POSE, quadrille-grasp-planner "
             "--pose-channel CAMERA_POSE");
  heard.other_channels = {"R2/CAMERA_POSE"};
  CHECK(check_poses(heard, "R2/")[0].remedy ==
        "quadrille-detector --pose-channel CAMERA_POSE, quadrille-grasp-planner --pose-channel "
        "CAMERA_POSE, with --channel-prefix R2/");
}

TEST_CASE("messages that are no valid poses are a failure", "[doctor][pose]") {
  PoseArrivals heard = make_heard();
  heard.refused = 2;
  heard.refusal = {bus::RejectReason::kBadValue, "orientation is not of unit norm"};
  check_only(heard, Verdict::kFailed,
             "2 of 302 messages on POSE are no valid poses: orientation is not of unit norm",
             "have the sender write finite numbers, and the orientation as a quaternion w, x, y, z "
             "of norm 1");
  heard.poses.clear();
  heard.refusal = {bus::RejectReason::kUnknownType, "not bot_core.pose_t"};
  check_only(heard, Verdict::kFailed,
             "2 of 2 messages on POSE are no valid poses: not bot_core.pose_t",
             "send bot_core.pose_t on it, and nothing else");
}

TEST_CASE("poses that stopped are a failure, and clouds after them are counted", "[doctor][pose]") {
  const std::string remedy = "start what sends the camera's poses, or the log, again";
  PoseArrivals heard = make_heard();
  heard.poses = make_arrivals(100.0, 0.005, 0.0, 1.0);
  check_only(heard, Verdict::kFailed,
             "the last one on POSE came 2.0 s before the end of listening; 20 of 30 clouds came "
             "after it",
             remedy);
  heard.clouds.clear();
  check_only(heard, Verdict::kFailed, "the last one on POSE came 2.0 s before the end of listening",
             remedy);
  heard.poses = make_arrivals(100.0, 0.005, 0.0, 2.1);
  CHECK_FALSE(has_failure(check_poses(heard)));
  heard.poses = make_arrivals(100.0, 0.0, 1.0, 1.01);
  check_only(heard, Verdict::kFailed, "the last one on POSE came 2.0 s before the end of listening",
             remedy);
}

TEST_CASE("slow poses have not stopped", "[doctor][pose]") {
  PoseArrivals heard = make_heard();
  heard.clouds.clear();
  heard.poses = make_arrivals(0.8, 0.005);
  heard.end = time_of(3.9);
  check_only(heard, Verdict::kWarning,
             "up to 1.25 s from one on POSE to the next, more than track.pose_age = 1 s",
             "send poses at 30 Hz or faster, without breaks");
}

TEST_CASE("poses of another clock than the clouds are a failure", "[doctor][pose]") {
  const std::string start = "utime on POSE is ", end = " that of clouds that come at the same time";
  const std::string both =
      "sudo timedatectl set-ntp true, on both machines; if their clocks "
      "agree, make the driver that is behind send sooner";
  PoseArrivals behind = make_heard(), ahead = make_heard(), other = make_heard();
  for (Arrival& pose : behind.poses) pose.utime -= 1'500'000;
  for (Arrival& pose : ahead.poses) pose.utime += 3'000'000;
  for (Arrival& pose : other.poses) pose.utime -= kNow;
  check_only(behind, Verdict::kFailed, start + "1.5 s behind" + end, both);
  check_only(ahead, Verdict::kFailed, start + "3.0 s ahead of" + end, both);
  check_only(other, Verdict::kFailed, start + "1800000000.0 s behind" + end,
             "stamp clouds and poses by one clock, with microseconds since 1970");
}

TEST_CASE("clocks are compared where poses and clouds come together", "[doctor][pose]") {
  PoseArrivals apart = make_heard();
  apart.clouds = make_arrivals(10.0, 0.001, 0.005, 0.5);
  apart.poses = make_arrivals(100.0, 0.005, 2.0);
  for (Arrival& pose : apart.poses) pose.utime -= 100'000'000;
  CHECK_FALSE(has_failure(check_poses(apart)));
  // Slow poses that are 0.3 s ahead, each 0.9 s after a cloud.
  PoseArrivals slow = make_heard();
  slow.poses = make_arrivals(1.0, 0.0);
  slow.clouds = make_arrivals(1.0, 0.0, 0.1);
  for (Arrival& pose : slow.poses) pose.utime += 300'000;
  CHECK_FALSE(has_failure(check_poses(slow)));
}

TEST_CASE("a log that is played has one clock of its own, and may begin anew", "[doctor][pose]") {
  PoseArrivals heard = make_heard();
  const auto set_back = [](std::deque<Arrival>* arrivals) {
    for (Arrival& one : *arrivals) one.utime -= kNow + (one.at > time_of(1.49) ? 1'490'000 : 0);
  };
  set_back(&heard.poses);
  set_back(&heard.clouds);
  check_only(heard, Verdict::kWarning, "utime went backwards at 1 of 300 poses on POSE",
             "one sender a channel, which sends poses in the order of their times; nothing if a "
             "log began anew");
}

TEST_CASE("poses later than the default wait name a wait that suffices", "[doctor][pose]") {
  check_only(make_heard(100.0, 0.2), Verdict::kWarning,
             "the pose after 30 of 30 clouds came more than track.pose_wait = 0.05 s later than "
             "the cloud, up to 0.204 s",
             "raise track.pose_wait to 0.3 (under [track] in --config FILE of both processes), or "
             "send poses faster");
  check_only(make_heard(100.0, 0.045), Verdict::kOk,
             "296 poses on POSE, 100.0 Hz; a cloud waits 49 ms for the pose after it (half of "
             "them), 49 ms at the most",
             "");
}

TEST_CASE("clouds from before the first pose heard are not held against the poses",
          "[doctor][pose]") {
  PoseArrivals heard = make_heard();
  heard.poses = make_arrivals(100.0, 0.005, 1.0);
  check_only(heard, Verdict::kOk,
             "200 poses on POSE, 100.0 Hz; a cloud waits 9 ms for the pose after it (half of "
             "them), 9 ms at the most",
             "");
}

TEST_CASE("poses with long times between them are told", "[doctor][pose]") {
  PoseArrivals heard = make_heard();
  heard.clouds.clear();
  std::erase_if(heard.poses, [](const Arrival& pose) {
    return pose.utime > time_of(1.0) && pose.utime < time_of(2.2);
  });
  check_only(heard, Verdict::kWarning,
             "up to 1.2 s from one on POSE to the next, more than track.pose_age = 1 s",
             "send poses at 30 Hz or faster, without breaks");
}

TEST_CASE("poses slower than the clouds are told", "[doctor][pose]") {
  PoseArrivals heard = make_heard(40.0, 0.001);
  heard.clouds = make_arrivals(60.0, 0.001, 0.005);
  check_only(heard, Verdict::kWarning,
             "40.0 Hz on POSE, slower than the clouds' 60.0 Hz: of the clouds between two poses "
             "only the newest is handled",
             "send poses at 60 Hz or faster");
  heard.clouds = make_arrivals(42.0, 0.001, 0.005);
  CHECK(check_poses(heard)[0].verdict == Verdict::kOk);
}

TEST_CASE("one pose is too few", "[doctor][pose]") {
  PoseArrivals heard = make_heard();
  heard.clouds.clear();
  heard.poses = make_arrivals(100.0, 0.005, 2.5, 2.51);
  check_only(heard, Verdict::kWarning, "only one on POSE in 3.0 s",
             "send poses at 30 Hz or faster; --seconds listens longer");
}

TEST_CASE("poses whose times go backwards are told", "[doctor][pose]") {
  PoseArrivals heard = make_heard();
  std::swap(heard.poses[50].utime, heard.poses[51].utime);
  check_only(heard, Verdict::kWarning, "utime went backwards at 1 of 300 poses on POSE",
             "one sender a channel, which sends poses in the order of their times; nothing if a "
             "log began anew");
}

TEST_CASE("hostile times are judged without overflow", "[doctor][pose][hostile]") {
  using Limits = std::numeric_limits<std::int64_t>;
  PoseArrivals heard = make_heard();
  heard.poses[7].utime = Limits::min();
  heard.poses[8].utime = Limits::max();
  heard.clouds[3].utime = Limits::min();
  heard.clouds[4].utime = Limits::max();
  CHECK_FALSE(check_poses(heard).empty());
}

}  // namespace
}  // namespace quadrille::doctor
