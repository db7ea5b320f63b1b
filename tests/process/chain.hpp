#pragma once

#include <CLI/CLI.hpp>
#include <lcmtypes/quadrille/grasps_t.hpp>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "process/detector/command_line.hpp"
#include "process/detector/node.hpp"
#include "process/planner/command_line.hpp"
#include "process/planner/node.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/bus/status_message.hpp"
#include "support/catch.hpp"

namespace quadrille::test {

template <class CommandLine>
auto settings_from(const std::string& arguments) {
  CLI::App app;
  const CommandLine command_line(app);
  app.parse(arguments);
  return command_line.settings();
}

/// Both processes with the options of their command lines, the one's quadrics given to the other.
class Chain {
 public:
  Chain(const std::string& detector, const std::string& planner)
      : detector_(settings_from<DetectorCommandLine>(detector), keep()),
        // Without a deadline, so that a slow machine changes no answer.
        planner_(settings_from<PlannerCommandLine>("--deadline-ms 0 " + planner), keep()) {}

  void take(const std::string& channel, const std::vector<std::byte>& bytes) {
    give(detector_, channel, bytes);
    give(planner_, channel, bytes);
    pass_on();
  }

  /// The planner is told only after the detector has answered.
  void take_slowly(const std::string& channel, const std::vector<std::byte>& bytes) {
    give(detector_, channel, bytes);
    pass_on();
    give(planner_, channel, bytes);
  }

  /// Nothing comes until clouds wait no longer.
  void wait() {
    for (Node* node : {static_cast<Node*>(&detector_), static_cast<Node*>(&planner_)}) {
      for (const Job& job : node->find_due_jobs(Node::Time::max())) node->work(job);
    }
    pass_on();
  }

  bus::QuadricsMessage quadrics() const {
    return std::get<bus::QuadricsMessage>(bus::decode_quadrics(published_.at("QUADRICS")));
  }
  detector_status_t detector_status() {
    detector_.publish_status({});
    return std::get<detector_status_t>(
        bus::decode_detector_status(published_.at("QUADRILLE_DETECTOR_STATUS")));
  }
  planner_status_t planner_status() {
    planner_.publish_status({});
    return std::get<planner_status_t>(
        bus::decode_planner_status(published_.at("QUADRILLE_PLANNER_STATUS")));
  }
  const std::vector<std::byte>& bytes_of(const std::string& channel) const {
    return published_.at(channel);
  }
  grasps_t grasps() const {
    const std::vector<std::byte>& bytes = published_.at("GRASPS");
    grasps_t message;
    REQUIRE(message.decode(bytes.data(), 0, static_cast<int>(bytes.size())) > 0);
    return message;
  }

 private:
  bus::Publish keep() {
    return [this](const std::string& channel, std::span<const std::byte> bytes) {
      published_[channel] = std::vector<std::byte>(bytes.begin(), bytes.end());
      if (channel == "QUADRICS") quadrics_are_new_ = true;
    };
  }
  static void give(Node& node, const std::string& channel, const std::vector<std::byte>& bytes) {
    for (const Job& job : node.take(Node::Time(), channel, bytes)) node.work(job);
    CHECK(node.failed() == 0);
  }
  /// Gives the messages of the detector to the planner.
  void pass_on() {
    if (std::exchange(quadrics_are_new_, false)) {
      give(planner_, "QUADRICS", published_.at("QUADRICS"));
    }
  }

  std::map<std::string, std::vector<std::byte>> published_;
  bool quadrics_are_new_ = false;
  DetectorNode detector_;
  PlannerNode planner_;
};

}  // namespace quadrille::test
