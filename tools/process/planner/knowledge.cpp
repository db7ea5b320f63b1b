#include "process/planner/knowledge.hpp"

#include <stdexcept>
#include <utility>

#include "io/file_bytes.hpp"
#include "io/planner/octree_file.hpp"
#include "poses/cloud_frame.hpp"
#include "poses/placement.hpp"
#include "quadrille/bus/occupancy_message.hpp"
#include "quadrille/bus/scene_messages.hpp"
#include "quadrille/grasping/rigid_motion.hpp"
#include "quadrille/grasping/shape.hpp"

namespace quadrille {
namespace {

/// The frame of what the command line says.
std::string given_frame(const PlannerSettings& settings) {
  return std::string(
      to_string(settings.has_fixed_frame() ? CloudFrame::kWorld : CloudFrame::kCamera));
}

void append(std::vector<CollisionShape> shapes, const Eigen::Isometry3d& X_KF,
            std::vector<CollisionShape>* to) {
  for (CollisionShape& shape : shapes) to->push_back(moved(std::move(shape), X_KF));
}

}  // namespace

Knowledge::Knowledge(const PlannerSettings& settings)
    : settings_(settings),
      robot_({0, given_frame(settings), settings.known.robot, {}}),
      obstacles_{"", {}} {}

bool Knowledge::receive(const std::string& channel, std::span<const std::byte> bytes,
                        Refusals* refusals) {
  // Shapes that make no solid, and maps that are none, are found only when they are made.
  const auto take = [&](auto decoded, const auto& use) {
    const auto message = refusals->accept(channel, std::move(decoded));
    if (!message) return;
    try {
      use(*message);
    } catch (const std::invalid_argument& error) {
      refusals->add(channel, {bus::RejectReason::kBadValue, error.what()});
    } catch (const io::FileError& error) {
      refusals->add(channel, {bus::RejectReason::kBadValue, error.what()});
    }
  };
  if (channel == settings_.obstacles_channel) {
    take(bus::decode_shapes(bytes), [&](const auto& message) { take_obstacles(message); });
  } else if (channel == settings_.map_channel) {
    take(bus::decode_occupancy(bytes), [&](const auto& message) { take_map(message); });
  } else if (channel == settings_.support_channel) {
    take(bus::decode_support(bytes), [&](const support_t& message) {
      const Eigen::Vector3d n(message.normal);
      support_ = {message.frame, std::nullopt};
      if (!n.isZero(0.0)) support_->value = KnownSupport{n.normalized(), message.offset};
    });
  } else if (channel == settings_.robot_channel) {
    robot_.receive(channel, bytes, refusals);
  } else {
    return false;
  }
  return true;
}

void Knowledge::take_obstacles(const collision_shapes_t& message) {
  std::vector<CollisionShape> shapes;
  for (const collision_shape_t& shape : message.shapes) {
    shapes.push_back(with_geometry(bus::from_message(shape)));
  }
  obstacles_ = {message.frame, std::move(shapes)};
}

void Knowledge::take_map(const occupancy_t& message) {
  const std::span<const std::byte> data(reinterpret_cast<const std::byte*>(message.data.data()),
                                        message.data.size());
  if (data.empty()) {
    map_ = {message.frame, nullptr};
  } else {
    map_ = {message.frame, io::parse_octree(data, "data")};
  }
}

Known Knowledge::about(const CloudAndQuadrics& pair) const {
  const std::int64_t utime = pair.cloud->utime;
  const std::string& cloud_frame = pair.cloud->cloud.frame;
  const auto X_KF = [&](const std::string& frame) {
    return pose_of_camera(frame, pair.placement, cloud_frame).inverse();
  };
  Known known;
  Surroundings given = settings_.known;
  given.robot = {};
  if (!settings_.obstacles.empty() || given.support || given.map.tree) {
    const Eigen::Isometry3d X_KW = X_KF(given_frame(settings_));
    known.surroundings = moved(std::move(given), X_KW);
    append(settings_.obstacles, X_KW, &known.obstacles);
  }
  if (!obstacles_.value.empty()) {
    append(obstacles_.value, X_KF(obstacles_.frame), &known.obstacles);
  }
  if (support_) known.surroundings.support.reset();
  if (support_ && support_->value) {
    known.surroundings.support =
        moved(Surroundings{{}, {}, support_->value, {}}, X_KF(support_->frame)).support;
  }
  if (map_) known.surroundings.map = {};
  if (map_ && map_->value) known.surroundings.map = {map_->value, X_KF(map_->frame)};
  known.surroundings.robot = robot_.at(utime, pair.placement, cloud_frame);
  known.attached = settings_.attached;
  for (const SolidShape& shape : robot_.attached_at(utime)) {
    known.attached.push_back(with_geometry(shape));
  }
  return known;
}

}  // namespace quadrille
