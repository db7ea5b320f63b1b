#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cloud_samples.hpp"
#include "found_samples.hpp"
#include "grasp_samples.hpp"
#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/pose_message.hpp"
#include "scene_samples.hpp"
#include "status_samples.hpp"

namespace quadrille::test {

/// A decoder with a message that it accepts.
struct Decoder {
  std::string type;
  std::vector<std::byte> valid;
  /// Returns why it refuses bytes; nullopt if it accepts them.
  std::function<std::optional<bus::RejectReason>(std::span<const std::byte>)> refusal;
  /// Most bytes that it may allocate for one byte of the message.
  std::size_t memory;
};

/// Returns why bytes were refused; nullopt if they were not.
template <class Message>
std::optional<bus::RejectReason> refusal_in(const bus::Decoded<Message>& decoded) {
  const auto* rejection = std::get_if<bus::Rejection>(&decoded);
  return rejection ? std::optional(rejection->reason) : std::nullopt;
}

/// Returns all decoders; the one of clouds once for each type that it reads.
inline std::vector<Decoder> all_decoders() {
  using Bytes = std::span<const std::byte>;
  using bus::encode;
  const auto cloud = [](Bytes b) { return refusal_in(bus::decode_cloud(b)); };
  const auto cloud_bytes = [](bus::CloudFormat format) {
    return bus::encode_cloud(make_cloud(), format);
  };
  const auto bodies = encode(bus::to_message(make_cloud(), make_bodies()));
  const auto boxes = encode(bus::to_message(make_cloud(), make_boxes()));
  return {
      {"drake cloud", cloud_bytes(bus::CloudFormat::kDrake), cloud, 3},
      {"pointcloud2", cloud_bytes(bus::CloudFormat::kPointCloud2), cloud, 3},
      {"pointcloud", cloud_bytes(bus::CloudFormat::kPointCloud), cloud, 3},
      {"drake cloud of float64", encode(make_wide_message(true)), cloud, 3},
      {"quadrics", make_quadrics_bytes(),
       [](Bytes b) { return refusal_in(bus::decode_quadrics(b)); }, 16},
      {"boxes", boxes, [](Bytes b) { return refusal_in(bus::decode_boxes(b)); }, 16},
      {"bodies", bodies, [](Bytes b) { return refusal_in(bus::decode_bodies(b)); }, 16},
      {"tracks of bodies", encode(make_body_tracks()),
       [](Bytes b) { return refusal_in(bus::decode_body_tracks(b)); }, 32},
      {"grasps", encode(make_grasps()), [](Bytes b) { return refusal_in(bus::decode_grasps(b)); },
       16},
      {"request", encode(make_request()),
       [](Bytes b) { return refusal_in(bus::decode_request(b)); }, 32},
      {"pose", encode(make_pose()), [](Bytes b) { return refusal_in(bus::decode_pose(b)); }, 1},
      {"map", encode(make_occupancy()),
       [](Bytes b) { return refusal_in(bus::decode_occupancy(b)); }, 3},
      {"shapes", encode(make_shapes_message()),
       [](Bytes b) { return refusal_in(bus::decode_shapes(b)); }, 16},
      {"robot", encode(make_robot_message()),
       [](Bytes b) { return refusal_in(bus::decode_robot(b)); }, 16},
      {"support", encode(make_support_message()),
       [](Bytes b) { return refusal_in(bus::decode_support(b)); }, 16},
      {"forget", encode(make_forget_message()),
       [](Bytes b) { return refusal_in(bus::decode_forget(b)); }, 16},
      {"detector's status", encode(make_detector_status()),
       [](Bytes b) { return refusal_in(bus::decode_detector_status(b)); }, 16},
      {"planner's status", encode(make_planner_status()),
       [](Bytes b) { return refusal_in(bus::decode_planner_status(b)); }, 16},
  };
}

}  // namespace quadrille::test
