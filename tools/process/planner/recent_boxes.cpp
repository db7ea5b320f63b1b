#include "process/planner/recent_boxes.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace quadrille {
namespace {

// Pairing keeps 32 clouds until their quadrics come, so boxes of older clouds are of no use.
constexpr std::size_t kMaxMessages = 32;

}  // namespace

void RecentBoxes::add(bus::BoxesMessage boxes) {
  messages_.push_back(std::move(boxes));
  if (messages_.size() > kMaxMessages) messages_.pop_front();
}

std::optional<std::vector<Box>> RecentBoxes::take(const bus::QuadricsMessage& quadrics) {
  const auto found = std::find_if(messages_.rbegin(), messages_.rend(), [&](const auto& boxes) {
    return boxes.utime == quadrics.utime && boxes.seq == quadrics.seq &&
           boxes.frame == quadrics.frame;
  });
  if (found == messages_.rend()) return std::nullopt;
  std::vector<Box> boxes = std::move(found->boxes);
  messages_.erase(messages_.begin(), found.base());
  return boxes;
}

}  // namespace quadrille
