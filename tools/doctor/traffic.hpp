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

/// What messages carry, told by their fingerprints.
enum class Kind { kCloud, kPose, kQuadrics, kGrasps, kDetectorStatus, kPlannerStatus, kOther };

Kind kind_of(std::int64_t fingerprint);

/// The messages of one sender on one channel.
struct Stream {
  std::string channel, sender;
  Kind kind = Kind::kOther;
  std::int64_t fingerprint = 0;
  std::int64_t messages = 0;
  std::uint32_t max_bytes = 0;
  /// When the first and the last one came [us].
  std::int64_t first = 0, last = 0;
  /// Times that the messages tell: the last one, how many were 0, and how many not newer than the
  /// one before [us].
  std::int64_t utime = 0, zero_utimes = 0, stale_utimes = 0;
};

/// One socket that sends, "ADDRESS:PORT".
struct Sender {
  std::int64_t messages = 0;
  /// Messages of which nothing came, and of which a part did not.
  std::int64_t missing = 0, incomplete = 0;
};

/// What was heard on the bus, kept within a bounded memory.
class Traffic {
 public:
  /// Senders and streams that are kept; what else comes is counted as crowded_out().
  static constexpr std::size_t kMaxStreams = 4096;

  /// @param now  when the datagram came [us]
  void add(const std::string& sender, std::span<const std::byte> datagram, std::int64_t now);

  std::vector<Stream> streams() const;
  const std::map<std::string, Sender>& senders() const { return senders_; }
  /// Datagrams that are none of LCM's, or crafted.
  std::int64_t malformed() const { return malformed_; }
  std::int64_t crowded_out() const { return crowded_out_; }
  /// The size of the largest cloud; 0 if none was heard [byte].
  std::uint32_t largest_cloud() const;

 private:
  struct Reception {
    std::optional<std::uint32_t> sequence;
    /// Fragments of the last message: those that came, those there are.
    std::uint32_t came = 0, fragments = 0;
  };

  void count_message(const std::string& sender, std::uint32_t sequence, std::uint32_t fragments);

  std::map<std::pair<std::string, std::string>, Stream> streams_;
  std::map<std::string, Sender> senders_;
  std::map<std::string, Reception> receptions_;
  std::int64_t malformed_ = 0, crowded_out_ = 0;
};

}  // namespace quadrille::doctor
