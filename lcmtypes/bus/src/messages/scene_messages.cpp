#include "quadrille/bus/scene_messages.hpp"

#include <cmath>
#include <string>

#include "messages/decode_checked.hpp"
#include "quadrille/bus/cloud_message.hpp"

namespace quadrille::bus {
namespace {

constexpr std::size_t kMaxKindBytes = 32;
// Size of a shape of which all lists are empty.
constexpr std::size_t kMinShapeBytes = 4 * sizeof(std::int32_t) + kMinStringBytes + kPoseBytes;

/// Reads a count, as ByteReader::read_count() does, that must not exceed a limit.
std::int32_t read_few(ByteReader& reader, const char* member, std::size_t min_element_bytes,
                      std::int32_t most) {
  const std::int32_t count = reader.read_count(member, min_element_bytes);
  if (count > most) refuse(RejectReason::kTooLarge, member + (" " + std::to_string(count)));
  return count;
}

void check_shape(ByteReader& reader) {
  reader.read_int32("target");
  reader.read_string("kind", kMaxKindBytes);
  reader.skip_pose();
  reader.skip_list("dimensions", sizeof(double),
                   [](ByteReader& list) { list.read_finite("dimensions"); });
  const std::int32_t vertices = read_few(reader, "vertices", 3 * sizeof(double), kMaxVertices);
  reader.skip_finite("vertices", 3 * vertices);
  const std::int32_t faces = read_few(reader, "faces", sizeof(std::int32_t), 8 * kMaxVertices);
  reader.take(faces, sizeof(std::int32_t), "faces");
}

void check_list_of_shapes(ByteReader& reader, const char* member) {
  for (std::int32_t k = read_few(reader, member, kMinShapeBytes, kMaxShapes); k > 0; --k) {
    check_shape(reader);
  }
}

void check_shapes(ByteReader& reader) {
  reader.read_int64("utime");
  reader.read_int32("seq");
  reader.read_string("frame", kMaxFrameBytes);
  check_list_of_shapes(reader, "shapes");
}

/// Checks the members with which the messages below begin.
void check_head(ByteReader& reader) {
  reader.read_int64("utime");
  reader.read_string("frame", kMaxFrameBytes);
}

void check_robot(ByteReader& reader) {
  check_head(reader);
  reader.read_finite("padding");
  check_list_of_shapes(reader, "shapes");
  check_list_of_shapes(reader, "attached");
}

void check_support(ByteReader& reader) {
  check_head(reader);
  const double square = reader.skip_finite("normal", 3);
  if (square != 0.0 && !(std::abs(square - 1.0) < 1e-6)) {
    refuse(RejectReason::kBadValue, "normal is not of unit norm");
  }
  reader.read_finite("offset");
}

void check_forget(ByteReader& reader) {
  check_head(reader);
  if (reader.read_int8("all") != 0) {
    reader.take(1, kPoseBytes + 3 * sizeof(double), "region");
    return;
  }
  reader.skip_pose();
  for (int k = 0; k < 3; ++k) {
    if (!(reader.read_finite("region_size") > 0.0)) {
      refuse(RejectReason::kBadValue, "region_size is not positive");
    }
  }
}

}  // namespace

Decoded<collision_shapes_t> decode_shapes(std::span<const std::byte> bytes) {
  return decode_checked<collision_shapes_t>(bytes, kMaxSceneBytes, check_shapes);
}

Decoded<robot_t> decode_robot(std::span<const std::byte> bytes) {
  return decode_checked<robot_t>(bytes, kMaxSceneBytes, check_robot);
}

Decoded<support_t> decode_support(std::span<const std::byte> bytes) {
  return decode_checked<support_t>(bytes, kMaxSceneBytes, check_support);
}

Decoded<forget_t> decode_forget(std::span<const std::byte> bytes) {
  return decode_checked<forget_t>(bytes, kMaxSceneBytes, check_forget);
}

SolidShape from_message(const collision_shape_t& message) {
  SolidShape shape;
  shape.kind = message.kind;
  shape.X_CS = from_message(message.pose);
  shape.dimensions = message.dimensions;
  for (const auto& vertex : message.vertices) shape.vertices_S.emplace_back(vertex.data());
  shape.faces.assign(message.faces.begin(), message.faces.end());
  shape.check();
  return shape;
}

}  // namespace quadrille::bus
