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

#include "poses/placement.hpp"
#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "quadrille/detector/body.hpp"

namespace quadrille {

/// The boxes and bodies that the detector found in a cloud, beside its quadrics.
struct OtherThings {
  /// Nullopt if the detector sent no boxes.
  std::optional<std::vector<Box>> boxes;
  std::vector<SceneBody> bodies;
};

/// A cloud and the quadrics that were found in it.
struct CloudAndQuadrics {
  std::shared_ptr<const bus::CloudMessage> cloud;
  /// Poses of the cloud and of the results.
  Placement placement;
  bus::QuadricsMessage quadrics;
  OtherThings others;
  /// Arrival time of the cloud or of the quadrics, whichever came later.
  std::chrono::steady_clock::time_point at;
};

/// Why no cloud was found for quadrics.
enum class Unpaired {
  kNoCloud,     ///< no cloud with their utime, seq and frame is kept
  kOtherCloud,  ///< only clouds with other points are kept
  kAmbiguous,   ///< several clouds match, and the quadrics carry no digest of theirs
};

/// Returns the name in status messages, such as "no_cloud".
const char* to_string(Unpaired why);
/// Returns the name with an explanation, for the log.
std::string explain(Unpaired why);

/// Pairs clouds with quadrics of the same utime, seq, frame and points, whichever comes first. The
/// quadrics may also be in the frame of the results. The digest of the points decides if senders do
/// not tell the time, or two senders share a channel. The detector takes a while, so the last
/// clouds are kept until their quadrics come.
class Pairing {
 public:
  /// @param max_clouds  number of clouds to keep, at least 1
  /// @param max_bytes  memory of the clouds to keep; the newest one is always kept
  explicit Pairing(std::size_t max_clouds = 32, std::size_t max_bytes = std::size_t{256} << 20);

  /// @return the pair if the cloud's quadrics came before it
  std::optional<CloudAndQuadrics> add(bus::CloudMessage cloud, Placement placement = {});

  /// @param others  what came with the quadrics
  /// @return the pair if the cloud of the quadrics is there; this cloud and older ones are then
  /// forgotten
  std::optional<CloudAndQuadrics> add(bus::QuadricsMessage quadrics, OtherThings others = {});

  std::int64_t paired() const { return paired_; }
  /// Number of quadrics whose cloud has not come.
  std::int64_t unpaired() const;
  std::int64_t unpaired(Unpaired why) const;
  /// Returns the counts of unpaired quadrics, with one entry for each reason that occurred.
  std::vector<count_t> count_unpaired() const;

  /// Quadrics that were given up.
  struct GivenUp {
    std::int64_t utime = 0;
    Unpaired why = Unpaired::kNoCloud;
  };
  /// Returns the last quadrics that were given up since the previous call.
  std::optional<GivenUp> take_given_up() { return std::exchange(given_up_, std::nullopt); }

 private:
  struct Kept {
    std::shared_ptr<const bus::CloudMessage> cloud;
    Placement placement;
  };
  struct Waiting {
    bus::QuadricsMessage quadrics;
    OtherThings others;
    Unpaired why;
  };
  std::variant<std::size_t, Unpaired> find_cloud(const bus::QuadricsMessage& quadrics) const;
  CloudAndQuadrics take_pair(std::size_t cloud, bus::QuadricsMessage quadrics, OtherThings others);
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
