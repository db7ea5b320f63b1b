#include <cmath>
#include <utility>

#include "decode_checked.hpp"
#include "quadrille/bus/boxes_message.hpp"
#include "quadrille/bus/quadrics_message.hpp"

namespace quadrille::bus {
namespace {

/// Size of a box without faces: two integers, 26 doubles and three flags.
constexpr std::size_t kMinBoxBytes = 2 * 4 + 26 * 8 + 3, kFaceBytes = 4;

void check_all_finite(ByteReader& reader, const char* member, int count) {
  for (int i = 0; i < count; ++i) reader.read_finite(member);
}

void check_box(ByteReader& reader) {
  reader.read_int32("id");
  const std::int32_t faces = reader.read_count("num_faces", kFaceBytes);
  reader.take(faces, kFaceBytes, "faces");
  check_all_finite(reader, "score", 1);
  check_all_finite(reader, "position", 3);
  double squared = 0.0;
  for (int i = 0; i < 4; ++i) squared += std::pow(reader.read_finite("quaternion"), 2);
  if (!(std::abs(squared - 1.0) < 1e-6)) {
    refuse(RejectReason::kBadValue, "quaternion is not of unit norm");
  }
  check_all_finite(reader, "size", 3);
  check_all_finite(reader, "std", 3);
  for (int i = 0; i < 3; ++i) reader.read_int8("seen");
  check_all_finite(reader, "bounds", 12);
}

void check_boxes(ByteReader& reader) {
  reader.read_int64("utime");
  reader.read_int32("seq");
  reader.read_string("frame", kMaxFrameBytes);
  const std::int32_t boxes = reader.read_count("num_boxes", kMinBoxBytes);
  if (static_cast<std::size_t>(boxes) > kMaxQuadrics) {
    refuse(RejectReason::kTooLarge, std::to_string(boxes) + " boxes");
  }
  for (std::int32_t i = 0; i < boxes; ++i) check_box(reader);
}

Eigen::AlignedBox3d bounds_of(const double (&min)[3], const double (&max)[3]) {
  return {Eigen::Vector3d(min), Eigen::Vector3d(max)};
}

Box to_box(const box_t& m) {
  Box box;
  box.id = m.id;
  box.faces.assign(m.faces.begin(), m.faces.end());
  box.score = m.score;
  box.X_CB = from_message(m.pose);
  box.size = Eigen::Vector3d(m.size);
  box.std = Eigen::Vector3d(m.std);
  for (int i = 0; i < 3; ++i) box.seen[i] = m.seen[i] != 0;
  box.inner_B = bounds_of(m.inner_min, m.inner_max);
  box.outer_B = bounds_of(m.outer_min, m.outer_max);
  return box;
}

BoxesMessage from_boxes(boxes_t m) {
  BoxesMessage message{m.utime, m.seq, std::move(m.frame), {}};
  for (const box_t& box : m.boxes) message.boxes.push_back(to_box(box));
  return message;
}

}  // namespace

Decoded<BoxesMessage> decode_boxes(std::span<const std::byte> bytes, std::size_t max_bytes) {
  return decode_checked<boxes_t, BoxesMessage>(bytes, max_bytes, check_boxes, from_boxes);
}

}  // namespace quadrille::bus
