#include "quadrille/bus/boxes_message.hpp"

#include <algorithm>

#include "quadrille/bus/quadrics_message.hpp"

namespace quadrille::bus {
namespace {

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
  boxes_t m;
  m.utime = cloud.utime;
  m.seq = cloud.seq;
  m.frame = cloud.cloud.frame;
  for (const Box& box : boxes) m.boxes.push_back(to_message(box));
  m.num_boxes = static_cast<std::int32_t>(m.boxes.size());
  return m;
}

}  // namespace quadrille::bus
