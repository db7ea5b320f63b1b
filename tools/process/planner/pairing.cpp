#include "process/planner/pairing.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "poses/waiting_clouds.hpp"

namespace quadrille {
namespace {

/// Returns true if the quadrics have the stamps of the cloud, whatever its points.
bool have_stamps_of(const bus::QuadricsMessage& quadrics, const bus::CloudMessage& cloud,
                    const Placement& placement) {
  const std::string& frame = cloud.cloud.frame;
  return cloud.utime == quadrics.utime && cloud.seq == quadrics.seq &&
         (quadrics.frame == frame || quadrics.frame == placement.frame_of_results(frame));
}

}  // namespace

const char* to_string(Unpaired why) {
  switch (why) {
    case Unpaired::kNoCloud:
      return "no_cloud";
    case Unpaired::kOtherCloud:
      return "other_cloud";
    case Unpaired::kAmbiguous:
      break;
  }
  return "ambiguous";
}

std::string explain(Unpaired why) {
  switch (why) {
    case Unpaired::kNoCloud:
      return "no cloud of their utime, seq and frame is kept (no_cloud); do both processes get the "
             "same clouds?";
    case Unpaired::kOtherCloud:
      return "all clouds kept of their utime have other points (other_cloud); have the clouds' "
             "senders tell the time";
    case Unpaired::kAmbiguous:
      break;
  }
  return "several clouds of their utime are kept, and they name no cloud_digest (ambiguous)";
}

Pairing::Pairing(std::size_t max_clouds, std::size_t max_bytes)
    : max_clouds_(max_clouds), max_bytes_(max_bytes) {
  if (max_clouds == 0) throw std::invalid_argument("max_clouds = 0: must be at least 1");
}

/// Returns the index of the cloud in which the quadrics were found. If several clouds have the same
/// points, any of them is right; the oldest is taken, so that the others wait for their own
/// quadrics.
std::variant<std::size_t, Unpaired> Pairing::find_cloud(
    const bus::QuadricsMessage& quadrics) const {
  std::optional<std::size_t> found;
  bool stamped = false;
  for (std::size_t i = 0; i < clouds_.size(); ++i) {
    const bus::CloudMessage& cloud = *clouds_[i].cloud;
    if (!have_stamps_of(quadrics, cloud, clouds_[i].placement)) continue;
    stamped = true;
    const bool known = quadrics.cloud_digest != 0;
    if (known && quadrics.cloud_digest != cloud.digest) continue;
    if (!found) found = i;
    if (!known && cloud.digest != clouds_[*found].cloud->digest) return Unpaired::kAmbiguous;
  }
  if (found) return *found;
  return stamped ? Unpaired::kOtherCloud : Unpaired::kNoCloud;
}

std::optional<CloudAndQuadrics> Pairing::add(bus::CloudMessage cloud, Placement placement) {
  bytes_ += memory_of(cloud.cloud);
  clouds_.push_back(
      {std::make_shared<const bus::CloudMessage>(std::move(cloud)), std::move(placement)});
  forget_old();
  if (!waiting_) return std::nullopt;
  const auto found = find_cloud(waiting_->quadrics);
  const auto* const index = std::get_if<std::size_t>(&found);
  if (index == nullptr) return std::nullopt;
  Waiting found_for = *std::exchange(waiting_, std::nullopt);
  return take_pair(*index, std::move(found_for.quadrics), std::move(found_for.others));
}

std::optional<CloudAndQuadrics> Pairing::add(bus::QuadricsMessage quadrics, OtherThings others) {
  const auto found = find_cloud(quadrics);
  if (const auto* index = std::get_if<std::size_t>(&found)) {
    return take_pair(*index, std::move(quadrics), std::move(others));
  }
  const Unpaired why = std::get<Unpaired>(found);
  // No later cloud can resolve this.
  if (why == Unpaired::kAmbiguous) {
    give_up(quadrics.utime, why);
    return std::nullopt;
  }
  if (waiting_) give_up(waiting_->quadrics.utime, waiting_->why);
  waiting_ = {std::move(quadrics), std::move(others), why};
  return std::nullopt;
}

void Pairing::give_up(std::int64_t utime, Unpaired why) {
  ++unpaired_[static_cast<std::size_t>(why)];
  given_up_ = {utime, why};
}

std::int64_t Pairing::unpaired(Unpaired why) const {
  return unpaired_[static_cast<std::size_t>(why)] + (waiting_ && waiting_->why == why ? 1 : 0);
}

std::int64_t Pairing::unpaired() const {
  std::int64_t sum = 0;
  for (std::size_t n = 0; n < kReasons; ++n) sum += unpaired(static_cast<Unpaired>(n));
  return sum;
}

std::vector<count_t> Pairing::count_unpaired() const {
  std::vector<count_t> counts;
  for (std::size_t n = 0; n < kReasons; ++n) {
    const auto why = static_cast<Unpaired>(n);
    if (unpaired(why) == 0) continue;
    counts.emplace_back();
    counts.back().name = to_string(why);
    counts.back().count = unpaired(why);
  }
  return counts;
}

CloudAndQuadrics Pairing::take_pair(std::size_t cloud, bus::QuadricsMessage quadrics,
                                    OtherThings others) {
  CloudAndQuadrics pair{clouds_[cloud].cloud, clouds_[cloud].placement, std::move(quadrics),
                        std::move(others), std::chrono::steady_clock::now()};
  for (std::size_t i = 0; i <= cloud; ++i) {
    bytes_ -= memory_of(clouds_.front().cloud->cloud);
    clouds_.pop_front();
  }
  ++paired_;
  return pair;
}

void Pairing::forget_old() {
  while (clouds_.size() > 1 && (clouds_.size() > max_clouds_ || bytes_ > max_bytes_)) {
    bytes_ -= memory_of(clouds_.front().cloud->cloud);
    clouds_.pop_front();
  }
}

}  // namespace quadrille
