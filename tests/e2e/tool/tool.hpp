#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace quadrille::e2e {

/// Clouds in each of the logs.
inline constexpr int kClouds = 6;

/// Bytes that a process must refuse, with the reason that it must give.
struct Garbage {
  std::string channel;
  std::vector<std::byte> bytes;
  std::string reason;
};

/// One message for each of the ways in which bytes may be hostile.
std::vector<Garbage> make_garbage();

/// How often each reason must be given for messages on a channel of the hostile log.
std::map<std::string, long> expected_rejections(const std::string& channel);

/// Writes FOLDER/clouds.lcm, and FOLDER/hostile.lcm with garbage between the same clouds, and
/// FOLDER/numbered.lcm with these as a type that has a seq.
void make_logs(const std::string& folder);

/// Checks that the quadrics of a log are those that detect() finds in its clouds, tracked: a ball
/// and a wall.
void check_quadrics(const std::string& log);

/// Checks that each message of a channel of the one log has equal bytes in the other, and that none
/// is missing but those that the status says were superseded.
void check_same(const std::string& live, const std::string& offline, const std::string& channel);

/// Checks that a log holds every event of another with its own time, and between them nothing but
/// results that carry the time of the event before them.
void check_copy(const std::string& source, const std::string& copy);

/// Checks that the last quadrics and grasps of a log are those of `quadrille plan --json`, bit for
/// bit, and that there are some.
/// @param other_frame  whether the results are in different frames; then positions are not compared
void check_plan(const std::string& log, const std::string& json, bool other_frame = false);

/// Checks the last status of both processes.
/// @param hostile  whether the garbage was on the bus too
void check_status(const std::string& log, bool hostile);

/// How clouds are sent to the processes.
struct Load {
  int bursts = 0;
  int clouds_per_burst = 1;
  double bursts_per_second = 30.0;
  /// Whether clouds may be lost: then the last comes alone, to tell what is missing before it.
  bool may_lose = false;
};

/// Sends the clouds of a log again and again, each with a number of its own, and prints what came
/// of them and when.
/// @throws std::runtime_error if the last cloud is not answered, nor of a burst where none may be
///   lost, or if one is neither received nor counted as missing
void put_under_load(const std::string& url, const std::string& log, const Load& load);

/// Messages that broken or hostile senders might send.
struct Hostile {
  long messages = 0;
  int seed = 1;
  /// Messages without a pause of a millisecond between them.
  int at_once = 10;
};

/// Sends random changes of the messages of a log, and good clouds between them.
/// @throws std::runtime_error if a good cloud is not answered on QUADRICS and GRASPS
void send_hostile(const std::string& url, const std::string& log, const Hostile& asked);
/// When the poses and the clouds of a camera come, which moves at half a metre a second: a pose
/// every 10 ms and a cloud every 100 ms.
struct PoseTiming {
  int clouds = 0;
  /// Share of the poses that arrive after the pose that follows them [%].
  int percent_disordered = 0;
  /// From the time of a pose or a cloud until it comes.
  int poses_late_ms = 0, clouds_late_ms = 0;
};

/// Writes a log of the poses (POSE) and the clouds (POINT_CLOUD, in the camera's frame).
void make_pose_log(const std::string& path, const PoseTiming& timing);

/// How many clouds get an answer with what was found, and one without for want of a pose.
struct PosesExpected {
  std::size_t placed = 0, refused = 0;
};

/// Prints what became of the clouds of such a log, whose results are in the fixed frame, and checks
/// it: the numbers, and that each ball lies within a millimetre of its true place.
void check_poses(const std::string& log, const PosesExpected& expected);

/// Checks that two logs hold the same quadrics and grasps, byte by byte and in one order.
void check_equal_results(const std::string& log, const std::string& other);

/// Checks that of the plans on the same clouds, those of a planner that remembers what earlier
/// clouds showed have fewer hands refused because space is unknown.
void check_remembered(const std::string& remembering, const std::string& forgetful);

/// Writes two views of a table: FOLDER/one.lcm with both on the channels of one camera,
/// FOLDER/front.lcm with the second there, and FOLDER/side.lcm with the first on those of another.
void make_camera_logs(const std::string& folder);

/// Checks that a log holds the same results on the second of these views as another one.
void check_cameras(const std::string& two, const std::string& one);

/// Counts what is found and grasped on the hand of which ROBOT tells in both logs, and checks that
/// there is nothing in the first, and something in the second.
void check_own_hand(const std::string& told, const std::string& untold);

/// Copies a log with one channel under another name.
void rename_channel(const std::string& source, const std::string& copy, const std::string& from,
                    const std::string& to);

}  // namespace quadrille::e2e
