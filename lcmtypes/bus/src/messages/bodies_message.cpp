#include "quadrille/bus/bodies_message.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "messages/decode_checked.hpp"

namespace quadrille::bus {
namespace {

/// Size of a body without parts: five integers, the kind, 16 doubles and three flags.
constexpr std::size_t kMinBodyBytes = 5 * 4 + 1 + 16 * 8 + 3;

/// A deviation may be infinite.
void check_deviation(double std) {
  if (!(std >= 0.0)) refuse(RejectReason::kBadValue, "std " + std::to_string(std));
}

/// A wall has a thickness and a finite deviation, or both are 0.
void check_wall(double wall, double std) {
  const bool known = wall > 0.0 && std >= 0.0 && std::isfinite(wall) && std::isfinite(std);
  if (known || (wall == 0.0 && std == 0.0)) return;
  refuse(RejectReason::kBadValue, "wall " + std::to_string(wall) + " " + std::to_string(std));
}

void check_body(ByteReader& reader) {
  reader.read_int32("id");
  const std::int8_t kind = reader.read_int8("kind");
  if (kind < body_t::SINGLE || kind > body_t::LUMP) {
    refuse(RejectReason::kBadValue, "kind " + std::to_string(kind));
  }
  reader.skip_array("parts", sizeof(std::int32_t));
  reader.skip_pose();
  reader.skip_finite("size", 3);
  for (int i = 0; i < 3; ++i) check_deviation(reader.read_double("std"));
  for (int i = 0; i < 3; ++i) reader.read_int8("seen");
  const double wall = reader.read_double("wall");
  check_wall(wall, reader.read_double("wall_std"));
  reader.read_int32("standing_on");
  if (reader.read_int32("points") < 0) refuse(RejectReason::kBadValue, "points");
  if (reader.read_int32("views") < 1) refuse(RejectReason::kBadValue, "views");
  const double unseen = reader.read_double("unseen");
  if (!(unseen >= 0.0) || std::isinf(unseen)) {
    refuse(RejectReason::kBadValue, "unseen " + std::to_string(unseen));
  }
}

void check_bodies(ByteReader& reader) {
  check_stamped_list(reader, "num_bodies", kMinBodyBytes, check_body);
}

SceneBody to_body(const body_t& m) {
  SceneBody body;
  body.id = m.id;
  body.kind = static_cast<BodyKind>(m.kind);
  body.parts.assign(m.parts.begin(), m.parts.end());
  body.X_CB = from_message(m.pose);
  body.size = Eigen::Vector3d(m.size);
  body.std = Eigen::Vector3d(m.std);
  for (int i = 0; i < 3; ++i) body.seen[i] = m.seen[i] != 0;
  if (m.wall > 0.0) body.wall = BodyWall{m.wall, m.wall_std};
  if (m.standing_on != 0) body.standing_on = m.standing_on;
  body.points = m.points;
  body.views = m.views;
  body.unseen = m.unseen;
  return body;
}

BodiesMessage from_bodies(bodies_t m) {
  BodiesMessage message{m.utime, m.seq, std::move(m.frame), {}};
  for (const body_t& body : m.bodies) message.bodies.push_back(to_body(body));
  return message;
}

}  // namespace

body_t to_message(const SceneBody& body) {
  static_assert(static_cast<int>(BodyKind::kLump) == body_t::LUMP);
  body_t m;
  m.id = body.id;
  m.kind = static_cast<std::int8_t>(body.kind);
  m.parts.assign(body.parts.begin(), body.parts.end());
  m.num_parts = static_cast<std::int32_t>(m.parts.size());
  m.pose = to_message(body.X_CB);
  std::copy_n(body.size.data(), 3, m.size);
  std::copy_n(body.std.data(), 3, m.std);
  for (int i = 0; i < 3; ++i) m.seen[i] = body.seen[i];
  const BodyWall wall = body.wall.value_or(BodyWall{});
  m.wall = wall.thickness, m.wall_std = wall.std;
  m.standing_on = body.standing_on.value_or(0);
  m.points = body.points;
  m.views = body.views;
  m.unseen = body.unseen;
  return m;
}

bodies_t to_message(const CloudMessage& cloud, const std::vector<SceneBody>& bodies) {
  auto m = stamped_as<bodies_t>(cloud);
  for (const SceneBody& body : bodies) m.bodies.push_back(to_message(body));
  m.num_bodies = static_cast<std::int32_t>(m.bodies.size());
  return m;
}

Decoded<BodiesMessage> decode_bodies(std::span<const std::byte> bytes, std::size_t max_bytes) {
  return decode_checked<bodies_t, BodiesMessage>(bytes, max_bytes, check_bodies, from_bodies);
}

}  // namespace quadrille::bus
