#include "process/planner/pairing.hpp"

#include <stdexcept>
#include <utility>

namespace quadrille {
namespace {

std::size_t memory_of(const bus::CloudMessage& cloud) {
  return cloud.cloud.points.capacity() * sizeof(Eigen::Vector3f);
}

}  // namespace

Pairing::Pairing(std::size_t max_clouds, std::size_t max_bytes)
    : max_clouds_(max_clouds), max_bytes_(max_bytes) {
  if (max_clouds == 0) throw std::invalid_argument("max_clouds = 0: must be at least 1");
}

bool Pairing::belong_together(const Waiting& waiting, const bus::QuadricsMessage& quadrics) {
  const bus::CloudMessage& cloud = *waiting.cloud;
  const std::string& frame = cloud.cloud.frame;
  return cloud.utime == quadrics.utime && cloud.seq == quadrics.seq &&
         (quadrics.frame == frame || quadrics.frame == waiting.placement.frame_of_results(frame));
}

std::optional<CloudAndQuadrics> Pairing::add(bus::CloudMessage cloud, Placement placement) {
  bytes_ += memory_of(cloud);
  clouds_.push_back(
      {std::make_shared<const bus::CloudMessage>(std::move(cloud)), std::move(placement)});
  forget_old();
  if (!waiting_ || !belong_together(clouds_.back(), *waiting_)) return std::nullopt;
  return take_pair(clouds_.size() - 1, *std::exchange(waiting_, std::nullopt));
}

std::optional<CloudAndQuadrics> Pairing::add(bus::QuadricsMessage quadrics) {
  for (std::size_t i = clouds_.size(); i-- > 0;) {
    if (belong_together(clouds_[i], quadrics)) return take_pair(i, std::move(quadrics));
  }
  if (waiting_) ++unpaired_;
  waiting_ = std::move(quadrics);
  return std::nullopt;
}

CloudAndQuadrics Pairing::take_pair(std::size_t cloud, bus::QuadricsMessage quadrics) {
  CloudAndQuadrics pair{clouds_[cloud].cloud, clouds_[cloud].placement, std::move(quadrics),
                        std::chrono::steady_clock::now()};
  for (std::size_t i = 0; i <= cloud; ++i) {
    bytes_ -= memory_of(*clouds_.front().cloud);
    clouds_.pop_front();
  }
  ++paired_;
  return pair;
}

void Pairing::forget_old() {
  while (clouds_.size() > 1 && (clouds_.size() > max_clouds_ || bytes_ > max_bytes_)) {
    bytes_ -= memory_of(*clouds_.front().cloud);
    clouds_.pop_front();
  }
}

}  // namespace quadrille
