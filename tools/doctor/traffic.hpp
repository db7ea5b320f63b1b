#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace quadrille::doctor {

/// The kinds of messages, which are recognised by their fingerprints.
enum class Kind { kCloud, kPose, kQuadrics, kGrasps, kDetectorStatus, kPlannerStatus, kOther };

Kind kind_of(std::int64_t fingerprint);

/// The messages of one sender on one channel.
struct Stream {
  std::string channel, sender;
  Kind kind = Kind::kOther;
  std::int64_t fingerprint = 0;
  std::int64_t messages = 0;
  std::uint32_t max_bytes = 0;
  /// Arrival times of the first and the last message [us].
  std::int64_t first = 0, last = 0;
  /// Times inside the messages [us]: the last one, the number that were 0, and the number not newer
  /// than the previous one.
  std::int64_t utime = 0, zero_utimes = 0, stale_utimes = 0;
};

/// One sending socket, "ADDRESS:PORT".
struct Sender {
  std::int64_t messages = 0;
  /// Number of messages of which nothing arrived, and of which only a part arrived.
  std::int64_t missing = 0, incomplete = 0;
};

/// The traffic heard on the bus, kept within bounded memory.
class Traffic {
 public:
  /// Limit of the senders and streams that are kept; datagrams of others are counted as
  /// crowded_out().
  static constexpr std::size_t kMaxStreams = 4096;

  /// @param now  arrival time of the datagram [us]
  void add(const std::string& sender, std::span<const std::byte> datagram, std::int64_t now);

  std::vector<Stream> streams() const;
  const std::map<std::string, Sender>& senders() const { return senders_; }
  /// Number of datagrams that are not LCM's, or were crafted.
  std::int64_t malformed() const { return malformed_; }
  std::int64_t crowded_out() const { return crowded_out_; }
  /// Size of the largest cloud; 0 if none was heard [byte].
  std::uint32_t largest_cloud() const;

 private:
  struct Reception {
    std::optional<std::uint32_t> sequence;
    /// Number of fragments of the last message that arrived, and that there are.
    std::uint32_t came = 0, fragments = 0;
  };

  void count_message(const std::string& sender, std::uint32_t sequence, std::uint32_t fragments);

  std::map<std::pair<std::string, std::string>, Stream> streams_;
  std::map<std::string, Sender> senders_;
  std::map<std::string, Reception> receptions_;
  std::int64_t malformed_ = 0, crowded_out_ = 0;
};

}  // namespace quadrille::doctor
