#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>

#include "process/runtime/camera_poses.hpp"
#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/bus/quadrics_message.hpp"

namespace quadrille {

/// A cloud and the quadrics that were found in it.
struct CloudAndQuadrics {
  std::shared_ptr<const bus::CloudMessage> cloud;
  /// How the cloud lies.
  Placement placement;
  bus::QuadricsMessage quadrics;
  /// When the later of the two came.
  std::chrono::steady_clock::time_point at;
};

/// Brings clouds and quadrics of the same utime, seq and frame together, whichever comes first. The
/// quadrics may be in the frame of the results, too.
/// The detector takes a while, so the last clouds are kept until their quadrics come.
class Pairing {
 public:
  /// @param max_clouds  clouds to keep, at least 1
  /// @param max_bytes   memory of the clouds to keep; the newest one is kept in any case
  explicit Pairing(std::size_t max_clouds = 32, std::size_t max_bytes = std::size_t{256} << 20);

  /// @return the pair if the cloud's quadrics came before it
  std::optional<CloudAndQuadrics> add(bus::CloudMessage cloud, Placement placement = {});

  /// @return the pair if the cloud of the quadrics is there; it and older ones are then forgotten
  std::optional<CloudAndQuadrics> add(bus::QuadricsMessage quadrics);

  std::int64_t paired() const { return paired_; }
  /// Quadrics whose cloud never came, or not yet.
  std::int64_t unpaired() const { return unpaired_ + (waiting_ ? 1 : 0); }

 private:
  struct Waiting {
    std::shared_ptr<const bus::CloudMessage> cloud;
    Placement placement;
  };
  static bool belong_together(const Waiting& waiting, const bus::QuadricsMessage& quadrics);
  CloudAndQuadrics take_pair(std::size_t cloud, bus::QuadricsMessage quadrics);
  void forget_old();

  std::size_t max_clouds_, max_bytes_, bytes_ = 0;
  std::deque<Waiting> clouds_;
  std::optional<bus::QuadricsMessage> waiting_;
  std::int64_t paired_ = 0, unpaired_ = 0;
};

}  // namespace quadrille
