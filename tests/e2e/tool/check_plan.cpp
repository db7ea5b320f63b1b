#include <fstream>
#include <lcmtypes/quadrille/grasps_t.hpp>
#include <lcmtypes/quadrille/quadrics_t.hpp>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "log/event_log.hpp"
#include "tool.hpp"

namespace quadrille::e2e {
namespace {

using nlohmann::json;

/// The last message of a channel.
template <class Message>
Message read_last(const std::string& path, const std::string& channel) {
  Message message;
  bool found = false;
  bus::LogReader log(path);
  while (const auto event = log.next()) {
    if (event->channel != channel) continue;
    found = message.decode(event->bytes.data(), 0, static_cast<int>(event->bytes.size())) > 0;
  }
  if (!found) throw std::runtime_error(path + ": nothing on " + channel);
  return message;
}

json to_json(const pose_t& pose) {
  return {{"position", pose.position}, {"quaternion", pose.quaternion}};
}

json to_json(const quadric_t& m) {
  json dimensions = json::object();
  for (const dimension_t& dimension : m.dimensions) dimensions[dimension.name] = dimension.value;
  return {{"id", m.id},       {"type", m.type},          {"q", m.q},
          {"score", m.score}, {"inliers", m.inliers},    {"rms", m.rms},
          {"seen", m.seen},   {"pose", to_json(m.pose)}, {"dimensions", dimensions}};
}

json to_json(const grasp_t& m) {
  return {{"target", m.target},
          {"score", m.score},
          {"X_CG", to_json(m.pose)},
          {"width", m.width},
          {"preshape", m.preshape},
          {"contacts", m.contacts},
          {"approach", m.approach},
          {"friction_needed", m.friction_needed},
          {"epsilon", m.epsilon},
          {"clearance", m.clearance},
          {"unknown_contact", m.unknown_contact != 0}};
}

/// Compares all members of the messages with those of the same names.
/// @param left_out  members that are not compared
template <class Message>
void compare(const std::vector<Message>& got, const json& wanted, const std::string& what,
             const std::set<std::string>& left_out) {
  if (wanted.empty() || got.size() != wanted.size()) {
    throw std::runtime_error(std::to_string(got.size()) + " " + what + " from the process, " +
                             std::to_string(wanted.size()) + " from the command");
  }
  for (std::size_t i = 0; i < got.size(); ++i) {
    const json one = to_json(got[i]);
    for (const auto& [key, value] : one.items()) {
      if (left_out.contains(key) || value == wanted[i].at(key)) continue;
      throw std::runtime_error(what + " " + std::to_string(i) + ": " + key + " is " + value.dump() +
                               " from the process, " + wanted[i].at(key).dump() +
                               " from the command");
    }
  }
}

}  // namespace

void check_plan(const std::string& log, const std::string& json_path, bool other_frame) {
  std::ifstream file(json_path);
  const json plan = json::parse(file);
  const std::set<std::string> left_out =
      other_frame ? std::set<std::string>{"q", "pose", "X_CG", "contacts"}
                  : std::set<std::string>{};
  compare(read_last<quadrics_t>(log, "QUADRICS").detections, plan.at("detections"), "quadrics",
          left_out);
  compare(read_last<grasps_t>(log, "GRASPS").grasps, plan.at("grasps"), "grasps", left_out);
}

}  // namespace quadrille::e2e
