// Counts the quadrics, bodies and grasps that lie on the robot's own hand, which a camera at its
// wrist has in its pictures.
#include <cstdio>
#include <lcmtypes/quadrille/grasps_t.hpp>
#include <lcmtypes/quadrille/robot_t.hpp>
#include <stdexcept>
#include <variant>

#include "log/event_log.hpp"
#include "quadrille/bus/bodies_message.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "tool.hpp"

namespace quadrille::e2e {
namespace {

/// The boxes of the hand in the camera's frame, which is that of the results.
class HandBoxes {
 public:
  explicit HandBoxes(const robot_t& robot) {
    for (const collision_shape_t& shape : robot.shapes) {
      const Eigen::Vector3d half =
          0.5 * Eigen::Vector3d(shape.dimensions.data()) + Eigen::Vector3d::Constant(robot.padding);
      boxes_.push_back({bus::from_message(shape.pose).inverse(), {-half, half}});
    }
  }
  bool hold(const Eigen::Vector3d& p_K) const {
    for (const auto& [X_SK, box_S] : boxes_) {
      if (box_S.contains(X_SK * p_K)) return true;
    }
    return false;
  }

 private:
  struct Placed {
    Eigen::Isometry3d X_SK;
    Eigen::AlignedBox3d box_S;
  };
  std::vector<Placed> boxes_;
};

/// Results in all, and on the hand.
struct Count {
  long all = 0, on_hand = 0;

  void add(bool is_on_hand) {
    ++all;
    on_hand += is_on_hand;
  }
};

struct Counts {
  Count quadrics, bodies, grasps;

  long on_hand() const { return quadrics.on_hand + bodies.on_hand + grasps.on_hand; }
};

template <class Message>
Message decode(const bus::LogReader::Event& event) {
  Message message;
  const int size = static_cast<int>(event.bytes.size());
  if (message.decode(event.bytes.data(), 0, size) != size) {
    throw std::runtime_error("a message on " + event.channel + " cannot be decoded");
  }
  return message;
}

HandBoxes hand_in(const std::string& path) {
  bus::LogReader log(path);
  while (const auto event = log.next()) {
    if (event->channel == "ROBOT") return HandBoxes(decode<robot_t>(*event));
  }
  throw std::runtime_error(path + " tells no hand");
}

Counts count_in(const std::string& path) {
  const HandBoxes hand = hand_in(path);
  Counts counts;
  bus::LogReader log(path);
  while (const auto event = log.next()) {
    if (event->channel == "QUADRICS") {
      const auto decoded = bus::decode_quadrics(event->bytes);
      for (const Detection& d : std::get<bus::QuadricsMessage>(decoded).detections) {
        counts.quadrics.add(hand.hold(d.X_CQ * Eigen::Vector3d(d.extent_Q.center())));
      }
    } else if (event->channel == "BODIES") {
      const auto decoded = bus::decode_bodies(event->bytes);
      for (const SceneBody& body : std::get<bus::BodiesMessage>(decoded).bodies) {
        counts.bodies.add(hand.hold(body.X_CB.translation()));
      }
    } else if (event->channel == "GRASPS") {
      for (const grasp_t& grasp : decode<grasps_t>(*event).grasps) {
        counts.grasps.add(hand.hold(Eigen::Vector3d(grasp.contacts[0])) ||
                          hand.hold(Eigen::Vector3d(grasp.contacts[1])));
      }
    }
  }
  return counts;
}

void print(const char* title, const Counts& counts) {
  std::printf("%s: on the hand %ld of %ld quadrics, %ld of %ld bodies, %ld of %ld grasps\n", title,
              counts.quadrics.on_hand, counts.quadrics.all, counts.bodies.on_hand,
              counts.bodies.all, counts.grasps.on_hand, counts.grasps.all);
}

}  // namespace

void check_own_hand(const std::string& told, const std::string& untold) {
  const Counts with = count_in(told), without = count_in(untold);
  print("told", with);
  print("not told", without);
  if (with.on_hand() != 0) throw std::runtime_error("something is found on the hand");
  if (with.grasps.all == 0) throw std::runtime_error("nothing can be grasped");
  if (without.on_hand() == 0) {
    throw std::runtime_error("nothing would be found on the hand either if it were not told");
  }
}

}  // namespace quadrille::e2e
