#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <lcmtypes/bot_core/pointcloud2_t.hpp>
#include <lcmtypes/bot_core/pointcloud_t.hpp>
#include <lcmtypes/bot_core/pose_t.hpp>
#include <lcmtypes/drake/lcmt_point_cloud.hpp>
#include <vector>

#include "quadrille/bus/bodies_message.hpp"
#include "quadrille/bus/body_tracks_message.hpp"
#include "quadrille/bus/boxes_message.hpp"
#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/grasps_message.hpp"
#include "quadrille/bus/pose_message.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/bus/request_message.hpp"

namespace {

using namespace quadrille;

/// The first byte chooses a fingerprint, so that the fuzzer need not guess one.
std::vector<std::byte> make_message(const std::uint8_t* data, std::size_t size) {
  const std::array<std::int64_t, 10> fingerprints = {drake::lcmt_point_cloud::getHash(),
                                                     bot_core::pointcloud2_t::getHash(),
                                                     bot_core::pointcloud_t::getHash(),
                                                     quadrics_t::getHash(),
                                                     bot_core::pose_t::getHash(),
                                                     boxes_t::getHash(),
                                                     grasps_t::getHash(),
                                                     grasp_request_t::getHash(),
                                                     bodies_t::getHash(),
                                                     body_tracks_t::getHash()};
  auto fingerprint = static_cast<std::uint64_t>(fingerprints[data[0] % fingerprints.size()]);
  std::vector<std::byte> message(8 + size - 1);
  for (int i = 7; i >= 0; --i, fingerprint >>= 8) {
    message[static_cast<std::size_t>(i)] = static_cast<std::byte>(fingerprint & 0xff);
  }
  std::memcpy(message.data() + 8, data + 1, size - 1);
  return message;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::vector<std::byte> message = make_message(data, size);
  const auto cloud = bus::decode_cloud(message);
  // The beginning is good wherever all is.
  if (std::holds_alternative<bus::CloudMessage>(cloud) && !bus::read_stamp(message)) std::abort();
  if (const auto* accepted = std::get_if<bus::CloudMessage>(&cloud)) {
    if (accepted->cloud.points.size() * 4 > message.size()) std::abort();
    if (bus::encode_cloud(*accepted, bus::CloudFormat::kDrake).empty()) std::abort();
  }
  const auto quadrics = bus::decode_quadrics(message);
  if (const auto* accepted = std::get_if<bus::QuadricsMessage>(&quadrics)) {
    DetectionResult result;
    result.detections = accepted->detections;
    bus::encode(bus::to_message(bus::CloudMessage{}, result));
  }
  const auto pose = bus::decode_pose(message);
  if (const auto* accepted = std::get_if<bus::PoseMessage>(&pose)) {
    if (!accepted->X_WC.matrix().allFinite()) std::abort();
  }
  const auto boxes = bus::decode_boxes(message);
  if (const auto* accepted = std::get_if<bus::BoxesMessage>(&boxes)) {
    for (const Box& box : accepted->boxes) {
      if (!box.X_CB.matrix().allFinite()) std::abort();
    }
  }
  const auto bodies = bus::decode_bodies(message);
  if (const auto* accepted = std::get_if<bus::BodiesMessage>(&bodies)) {
    for (const SceneBody& body : accepted->bodies) {
      if (!body.X_CB.matrix().allFinite()) std::abort();
    }
  }
  const auto tracks = bus::decode_body_tracks(message);
  if (const auto* accepted = std::get_if<bus::BodyTracksMessage>(&tracks)) {
    for (const auto& [id, track] : accepted->track_of) {
      if (track < 1) std::abort();
    }
  }
  // What is accepted is written as it came.
  const auto grasps = bus::decode_grasps(message);
  if (const auto* accepted = std::get_if<grasps_t>(&grasps)) {
    if (bus::encode(*accepted).size() != message.size()) std::abort();
  }
  const auto request = bus::decode_request(message);
  if (const auto* accepted = std::get_if<grasp_request_t>(&request)) {
    if (bus::encode(*accepted).size() != message.size()) std::abort();
  }
  return 0;
}
