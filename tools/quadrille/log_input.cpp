#include "quadrille/log_input.hpp"

#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "io/describe.hpp"
#include "io/file_bytes.hpp"
#include "log/event_log.hpp"
#include "logs/posed_log_reader.hpp"
#include "poses/cloud_frame.hpp"
#include "poses/placement.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/printable.hpp"

namespace quadrille {
namespace {

using Visitor = std::function<void(InputCloud)>;

/// Returns the placement of a cloud in its camera's frame whose results are in the fixed frame.
Placement in_world_of(const CameraPose& pose) {
  Placement placement;
  placement.X_WK = pose.X_WK;
  placement.X_RK = pose.X_WK.value_or(Eigen::Isometry3d::Identity());
  placement.frame = to_string(CloudFrame::kWorld);
  placement.lack = pose.detail;
  return placement;
}

}  // namespace

logs::PosedLogReader open_log(const std::string& path, const InputArguments& arguments) {
  return {path,
          arguments.channel,
          arguments.pose_channel,
          arguments.track.pose_age,
          arguments.track.pose_wait,
          arguments.frames.unit,
          arguments.robot_channel};
}

std::optional<LogCloud> read_logged_cloud(logs::PosedLogReader& reader, const std::string& path,
                                          const InputArguments& arguments, int number) {
  const auto start = std::chrono::steady_clock::now();
  auto posed = reader.next();
  if (!posed) return std::nullopt;
  LogCloud found;
  InputCloud& input = found.input;
  bus::CloudMessage& message = posed->cloud.message;
  const bool in_world = !arguments.pose_channel.empty();
  const std::string frame = message.cloud.frame;
  const Placement placement = in_world ? in_world_of(posed->pose) : arguments.frames.placement();
  found.lack = placement.lack;
  input.X_CK = placement.X_RK;
  input.cloud = moved(std::move(message.cloud), placement.X_CK.inverse());
  if (in_world) {
    input.cloud.frame = placement.frame;
  } else {
    arguments.frames.place_viewpoint(&input.cloud);
  }
  if (posed->robot && found.lack.empty()) {
    input.attached = posed->robot->attached;
    try {
      input.robot = posed->robot->in_camera_frame(placement, frame);
    } catch (const std::invalid_argument& error) {
      found.robot_lack = error.what();
    }
  }
  input.describe(path + "#" + std::to_string(number), start);
  input.share = reader.clouds().share();
  input.channel = posed->cloud.channel;
  input.utime = message.utime;
  return found;
}

namespace {

using Counts = std::map<std::string, std::int64_t>;

std::string describe_no_cloud(const logs::CloudLogReader& reader, const std::string& channel) {
  if (channel.empty() || reader.channels().empty()) {
    return "holds no cloud; record POINT_CLOUD messages";
  }
  return fmt::format("holds no cloud on {}, but events on {}; name another --channel",
                     printable(channel), io::list_channels(reader.channels()));
}

/// @param clouds  number of clouds of each channel
std::vector<std::string> warnings_about(const logs::CloudLogReader& reader,
                                        const std::string& channel, const Counts& clouds) {
  std::vector<std::string> warnings;
  if (reader.defect()) warnings.push_back(*reader.defect());
  for (const bus::RejectReason reason : bus::all_reject_reasons()) {
    const auto count = reader.rejected().of(reason);
    if (count == 0) continue;
    warnings.push_back("refused " + io::count_of(static_cast<std::size_t>(count), "message") +
                       ": " + std::string(to_string(reason)));
  }
  if (clouds.empty()) warnings.push_back(describe_no_cloud(reader, channel));
  if (clouds.size() > 1) {
    warnings.push_back(
        fmt::format("holds clouds of several channels, {}; choose one with --channel",
                    io::list_channels(clouds)));
  }
  return warnings;
}

/// Returns true if clouds of a log are taken for views from one place only because nobody said
/// where their camera was.
bool lacks_poses(const InputArguments& arguments, int clouds) {
  return arguments.scene && clouds > 1 && arguments.pose_channel.empty() &&
         !arguments.frames.camera.X_WK;
}

/// Adds warnings that the robot's points stay in clouds.
/// @param lack  why shapes that were told could not be placed; empty if none was
void warn_of_robot(const std::string& lack, const logs::RobotRefusals& refusals,
                   const std::string& channel, std::vector<std::string>* warnings) {
  if (!lack.empty()) {
    warnings->push_back(
        fmt::format("the robot's shapes on {} cannot be placed, so its points are taken for "
                    "things: {}",
                    printable(channel), lack));
  }
  if (auto refused = refusals.warning(channel)) warnings->push_back(*std::move(refused));
}

constexpr const char* kUnmoved =
    "its clouds are taken as if their camera had not moved; name the channel of its poses with "
    "--pose-channel, or for a camera at rest its pose with --camera-pose";

/// Visits the cloud of a log with the given number, and before it the ones before if they show the
/// same scene.
std::vector<std::string> visit_numbered(const LogName& log, const InputArguments& arguments,
                                        const Visitor& visit) {
  logs::PosedLogReader reader = open_log(log.path, arguments);
  int clouds = 0;
  while (auto found = read_logged_cloud(reader, log.path, arguments, clouds + 1)) {
    InputCloud& input = found->input;
    input.asked = ++clouds == *log.number;
    if (!input.asked) {
      if (arguments.scene && found->lack.empty()) visit(std::move(input));
      continue;
    }
    if (!found->lack.empty()) {
      throw io::FileError(
          log.path, "",
          fmt::format("the pose of the camera of cloud #{} is not known: {}", clouds, found->lack));
    }
    input.warnings = warnings_about(reader.clouds(), arguments.channel, {{input.channel, 1}});
    if (lacks_poses(arguments, clouds)) input.warnings.push_back(kUnmoved);
    warn_of_robot(found->robot_lack, reader.robot_refusals(), arguments.robot_channel,
                  &input.warnings);
    std::vector<std::string> warnings = input.warnings;
    visit(std::move(input));
    return warnings;
  }
  const std::string held =
      clouds == 0
          ? describe_no_cloud(reader.clouds(), arguments.channel)
          : fmt::format("holds {}{}", io::count_of(static_cast<std::size_t>(clouds), "cloud"),
                        arguments.channel.empty()
                            ? ""
                            : fmt::format(" on {}", printable(arguments.channel)));
  throw io::FileError(log.path, "", fmt::format("there is no cloud #{}; it {}", *log.number, held));
}

/// The clouds of a log whose poses are not known.
struct Poseless {
  int clouds = 0, first = 0;
  std::string why_first;

  void add(int number, const std::string& why) {
    if (clouds++ > 0) return;
    first = number;
    why_first = why;
  }
  /// @param of  number of clouds of the log
  std::string describe(int of) const {
    return fmt::format(
        "{} of {} clouds are left out, since the pose of their camera is not known; the first is "
        "#{}: {}",
        clouds, of, first, why_first);
  }
};

/// Visits the clouds of a log. Each cloud waits for the next one, because defects of a log are
/// known only at its end and are reported with the last cloud.
/// @throws io::FileError if it has clouds, but none with a pose
std::vector<std::string> visit_all(const std::string& path, const InputArguments& arguments,
                                   const Visitor& visit) {
  logs::PosedLogReader reader = open_log(path, arguments);
  Counts clouds;
  int number = 0;
  std::optional<InputCloud> last;
  Poseless poseless;
  std::string robot_lack;
  while (auto found = read_logged_cloud(reader, path, arguments, number + 1)) {
    ++number;
    ++clouds[found->input.channel];
    if (!found->lack.empty()) {
      poseless.add(number, found->lack);
      continue;
    }
    if (robot_lack.empty()) robot_lack = found->robot_lack;
    if (last) visit(std::move(*last));
    last = std::move(found->input);
  }
  if (!last && poseless.clouds > 0) throw io::FileError(path, "", poseless.describe(number));
  std::vector<std::string> warnings = warnings_about(reader.clouds(), arguments.channel, clouds);
  if (poseless.clouds > 0) warnings.push_back(poseless.describe(number));
  if (lacks_poses(arguments, number)) warnings.push_back(kUnmoved);
  warn_of_robot(robot_lack, reader.robot_refusals(), arguments.robot_channel, &warnings);
  if (!last) return warnings;
  last->warnings = warnings;
  visit(std::move(*last));
  return warnings;
}

}  // namespace

bool is_log(const std::string& path) { return path.ends_with(".lcm") || bus::starts_as_log(path); }

std::optional<LogName> log_name_of(const std::string& text) {
  std::error_code ignored;
  if (is_log(text)) return LogName{text, {}};
  const std::size_t mark = text.rfind('#');
  if (mark == std::string::npos || std::filesystem::exists(text, ignored)) return std::nullopt;
  LogName name{text.substr(0, mark), 0};
  if (!is_log(name.path)) return std::nullopt;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data() + mark + 1, end, *name.number);
  if (error == std::errc{} && rest == end && *name.number > 0) return name;
  throw io::FileError(name.path, "",
                      fmt::format("'{}' is no number of a cloud; they count from #1",
                                  printable(text.substr(mark))));
}

std::vector<std::string> visit_log(const LogName& log, const InputArguments& arguments,
                                   const Visitor& visit) {
  return log.number ? visit_numbered(log, arguments, visit) : visit_all(log.path, arguments, visit);
}

}  // namespace quadrille
