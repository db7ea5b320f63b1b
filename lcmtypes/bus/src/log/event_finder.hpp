#pragma once

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace quadrille::bus {

/// The first bytes of each event's header.
inline constexpr std::string_view kLogMark = "\xed\xa1\xda\x01";
/// Length of the longest channel name that LCM's own reader accepts.
inline constexpr std::uint32_t kMaxChannelBytes = 999;

/// Position of an event in a log, and the values of its header.
struct EventPlace {
  /// Offset of its first byte, and of the byte after its last.
  std::uint64_t begin = 0, end = 0;
  std::int64_t utime = 0;
  std::uint32_t channel_bytes = 0, data_bytes = 0;
};

/// Finds the complete events of a log by their headers. The mark of a header may also occur within
/// data, so behind damaged bytes it continues only at a header whose event ends at the next header
/// or at the end of the file.
class EventFinder {
 public:
  /// @throws std::runtime_error naming the file if it is missing, cannot be read or is not an LCM
  ///   log
  explicit EventFinder(const std::string& path);

  /// Returns the next complete event; nullopt at the end.
  std::optional<EventPlace> next();

  /// Describes the bytes so far that were no event, as "cut short at byte N: …" or "damaged at byte
  /// N: …"; nullopt if there were none.
  std::optional<std::string> defect() const;

  /// Reads the bytes at an offset; returns false if the file has become shorter.
  bool read(std::uint64_t offset, std::span<std::byte> bytes);

 private:
  /// Parses the header in these bytes, which are at the given offset of the file; nullopt if there
  /// is none or its values are absurd.
  std::optional<EventPlace> header_in(std::span<const std::byte> bytes, std::uint64_t offset) const;
  std::optional<EventPlace> header_at(std::uint64_t offset);
  bool is_followed_well(const EventPlace& event);
  /// Finds the first event from an offset on that is followed by another event or by the end of the
  /// file.
  std::optional<EventPlace> find_from(std::uint64_t offset);
  /// Describes how the end of the file truncates an event that begins at an offset; empty if none
  /// does.
  std::string describe_cut(std::uint64_t begin);
  void note_gap(std::uint64_t begin, std::uint64_t end);

  std::uint64_t size_ = 0, at_ = 0;
  std::ifstream file_;
  std::uint64_t damages_ = 0, first_damage_ = 0, damaged_bytes_ = 0;
  std::string cut_;
};

}  // namespace quadrille::bus
