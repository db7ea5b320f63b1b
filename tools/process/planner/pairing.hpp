#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <lcmtypes/quadrille/count_t.hpp>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

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

/// Why quadrics have no cloud.
enum class Unpaired {
  kNoCloud,     ///< none of their utime, seq and frame is kept
  kOtherCloud,  ///< only ones of other points
  kAmbiguous,   ///< several, and they do not name the digest of theirs
};

/// Its name in status messages, such as "no_cloud".
const char* to_string(Unpaired why);
/// What it means, with its name, for the log.
std::string explain(Unpaired why);

/// Brings clouds and quadrics of the same utime, seq, frame and points together, whichever comes
/// first. The quadrics may be in the frame of the results, too. The digest of the points decides
/// where senders do not tell the time, or two have one channel.
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
  std::int64_t unpaired() const;
  std::int64_t unpaired(Unpaired why) const;
  /// One entry for each reason that occurred.
  std::vector<count_t> count_unpaired() const;

  /// Quadrics that were given up.
  struct GivenUp {
    std::int64_t utime = 0;
    Unpaired why = Unpaired::kNoCloud;
  };
  /// The last quadrics that were given up since the last call.
  std::optional<GivenUp> take_given_up() { return std::exchange(given_up_, std::nullopt); }

 private:
  struct Kept {
    std::shared_ptr<const bus::CloudMessage> cloud;
    Placement placement;
  };
  struct Waiting {
    bus::QuadricsMessage quadrics;
    Unpaired why;
  };
  std::variant<std::size_t, Unpaired> find_cloud(const bus::QuadricsMessage& quadrics) const;
  CloudAndQuadrics take_pair(std::size_t cloud, bus::QuadricsMessage quadrics);
  void give_up(std::int64_t utime, Unpaired why);
  void forget_old();

  static constexpr std::size_t kReasons = 3;

  std::size_t max_clouds_, max_bytes_, bytes_ = 0;
  std::deque<Kept> clouds_;
  std::optional<Waiting> waiting_;
  std::int64_t paired_ = 0;
  std::array<std::int64_t, kReasons> unpaired_{};
  std::optional<GivenUp> given_up_;
};

}  // namespace quadrille
