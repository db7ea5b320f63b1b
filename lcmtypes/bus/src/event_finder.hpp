#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace quadrille::bus {

/// The first bytes of each event's header.
inline constexpr std::string_view kLogMark = "\xed\xa1\xda\x01";
/// LCM's own reader refuses longer names.
inline constexpr std::uint32_t kMaxChannelBytes = 999;

/// Where an event stands in a log, and what its header says.
struct EventPlace {
  /// Its first byte, and the one behind its last.
  std::uint64_t begin = 0, end = 0;
  std::int64_t utime = 0;
  std::uint32_t channel_bytes = 0, data_bytes = 0;
};

/// Finds the whole events of a log by their headers. Behind damaged bytes it goes on where a header
/// stands whose event ends at the next header or with the file, for the mark of a header alone may
/// stand in any data.
class EventFinder {
 public:
  /// @throws std::runtime_error naming the file if it is missing, cannot be read or is no LCM log
  explicit EventFinder(const std::string& path);
  EventFinder(const EventFinder&) = delete;
  EventFinder& operator=(const EventFinder&) = delete;
  ~EventFinder();

  /// The next whole event; nullopt at the end.
  std::optional<EventPlace> next();

  /// What was no event so far, "cut short at byte N: …" or "damaged at byte N: …"; nullopt if
  /// there was no such byte.
  std::optional<std::string> defect() const;

  /// Fills the bytes from what stands at an offset; false if the file has become shorter.
  bool read(std::uint64_t offset, std::span<std::byte> bytes) const;

 private:
  /// The header that stands in these bytes at an offset; nullopt if there is none, or an absurd
  /// one.
  std::optional<EventPlace> header_in(std::span<const std::byte> bytes, std::uint64_t offset) const;
  std::optional<EventPlace> header_at(std::uint64_t offset) const;
  bool is_followed_well(const EventPlace& event) const;
  /// The first event from an offset on that is followed well.
  std::optional<EventPlace> find_from(std::uint64_t offset) const;
  /// How the end of the file cuts an event short that begins at an offset; empty if none does.
  std::string describe_cut(std::uint64_t begin) const;
  void note_gap(std::uint64_t begin, std::uint64_t end);

  int fd_ = -1;
  std::uint64_t size_ = 0, at_ = 0;
  std::uint64_t damages_ = 0, first_damage_ = 0, damaged_bytes_ = 0;
  std::string cut_;
};

}  // namespace quadrille::bus
