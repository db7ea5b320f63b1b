#include "quadrille/bus/boxes_message.hpp"

#include <algorithm>
#include <utility>

#include "messages/decode_checked.hpp"

namespace quadrille::bus {
namespace {

/// Size of a box without faces: two integers, 26 doubles and three flags.
constexpr std::size_t kMinBoxBytes = 2 * 4 + 26 * 8 + 3;

void check_box(ByteReader& reader) {
  reader.read_int32("id");
  reader.skip_array("faces", sizeof(std::int32_t));
  reader.read_finite("score");
  reader.skip_pose();
  reader.skip_finite("size", 3);
  reader.skip_finite("std", 3);
  for (int i = 0; i < 3; ++i) reader.read_int8("seen");
  reader.skip_finite("bounds", 12);
}

void check_boxes(ByteReader& reader) {
  check_stamped_list(reader, "num_boxes", kMinBoxBytes, check_box);
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

void copy_to(const Eigen::Vector3d& from, double to[3]) { std::copy_n(from.data(), 3, to); }

}  // namespace

box_t to_message(const Box& box) {
  box_t m;
  m.id = box.id;
  m.faces.assign(box.faces.begin(), box.faces.end());
  m.num_faces = static_cast<std::int32_t>(m.faces.size());
  m.score = box.score;
  m.pose = to_message(box.X_CB);
  copy_to(box.size, m.size);
  copy_to(box.std, m.std);
  for (int i = 0; i < 3; ++i) m.seen[i] = box.seen[i];
  copy_to(box.inner_B.min(), m.inner_min);
  copy_to(box.inner_B.max(), m.inner_max);
  copy_to(box.outer_B.min(), m.outer_min);
  copy_to(box.outer_B.max(), m.outer_max);
  return m;
}

boxes_t to_message(const CloudMessage& cloud, const std::vector<Box>& boxes) {
  auto m = stamped_as<boxes_t>(cloud);
  for (const Box& box : boxes) m.boxes.push_back(to_message(box));
  m.num_boxes = static_cast<std::int32_t>(m.boxes.size());
  return m;
}

Decoded<BoxesMessage> decode_boxes(std::span<const std::byte> bytes, std::size_t max_bytes) {
  return decode_checked<boxes_t, BoxesMessage>(bytes, max_bytes, check_boxes, from_boxes);
}

}  // namespace quadrille::bus
