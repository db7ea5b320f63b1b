#include "log/event_finder.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <vector>

#include "messages/byte_reader.hpp"
#include "quadrille/bus/cloud_message.hpp"

namespace quadrille::bus {
namespace {

/// Size of an event's header: its mark, number (8), time (8), length of the channel's name, length
/// of the data.
constexpr std::uint64_t kHeaderBytes = 28;

bool begins_with(std::span<const std::byte> bytes, std::string_view text) {
  return bytes.size() >= text.size() && std::memcmp(bytes.data(), text.data(), text.size()) == 0;
}

[[noreturn]] void fail(const std::string& path, const std::string& what) {
  throw std::runtime_error(path + ": " + what);
}

std::uint64_t size_of(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) fail(path, "no such file; check the path");
  if (!std::filesystem::is_regular_file(path, error)) fail(path, "is not a file; give an LCM log");
  const std::uint64_t size = std::filesystem::file_size(path, error);
  if (error) fail(path, error.message());
  return size;
}

}  // namespace

EventFinder::EventFinder(const std::string& path)
    : size_(size_of(path)), file_(path, std::ios::binary) {
  if (!file_) fail(path, std::string(std::strerror(errno)) + "; check its permissions");
  std::array<std::byte, kLogMark.size()> mark{};
  if (size_ == 0 || (read(0, mark) && begins_with(mark, kLogMark))) return;
  fail(path, "is not an LCM log (no event at byte 0); give one that lcm-logger recorded");
}

bool EventFinder::read(std::uint64_t offset, std::span<std::byte> bytes) {
  file_.clear();
  file_.seekg(static_cast<std::streamoff>(offset));
  file_.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return file_.good();
}

std::optional<EventPlace> EventFinder::header_in(std::span<const std::byte> bytes,
                                                 std::uint64_t offset) const {
  if (bytes.size() < kHeaderBytes || !begins_with(bytes, kLogMark)) return std::nullopt;
  ByteReader reader(bytes);
  reader.take(1, kLogMark.size() + sizeof(std::int64_t), "the mark and the number");
  EventPlace event;
  event.begin = offset;
  event.utime = reader.read_int64("time");
  event.channel_bytes = static_cast<std::uint32_t>(reader.read_int32("length of the name"));
  event.data_bytes = static_cast<std::uint32_t>(reader.read_int32("length of the data"));
  event.end = offset + kHeaderBytes + event.channel_bytes + event.data_bytes;
  const bool absurd_data = event.data_bytes >= std::numeric_limits<std::int32_t>::max() ||
                           (event.data_bytes > kMaxMessageBytes && event.end > size_);
  const bool absurd_name = event.channel_bytes == 0 || event.channel_bytes > kMaxChannelBytes;
  return absurd_name || absurd_data ? std::nullopt : std::optional(event);
}

std::optional<EventPlace> EventFinder::header_at(std::uint64_t offset) {
  std::array<std::byte, kHeaderBytes> raw{};
  if (offset > size_ || size_ - offset < kHeaderBytes || !read(offset, raw)) return std::nullopt;
  return header_in(raw, offset);
}

bool EventFinder::is_followed_well(const EventPlace& event) {
  return event.end == size_ || (event.end < size_ && header_at(event.end));
}

std::optional<EventPlace> EventFinder::find_from(std::uint64_t offset) {
  constexpr std::uint64_t kPiece = 1 << 16;
  std::vector<std::byte> piece;
  for (; offset + kHeaderBytes <= size_; offset += kPiece) {
    // A header may extend into the next piece.
    piece.resize(std::min(kPiece + kHeaderBytes - 1, size_ - offset));
    if (!read(offset, piece)) return std::nullopt;
    const std::string_view text(reinterpret_cast<const char*>(piece.data()), piece.size());
    for (auto at = text.find(kLogMark); at < kPiece; at = text.find(kLogMark, at + 1)) {
      const auto event = header_in(std::span(piece).subspan(at), offset + at);
      if (event && is_followed_well(*event)) return event;
    }
  }
  return std::nullopt;
}

std::string EventFinder::describe_cut(std::uint64_t begin) {
  const std::uint64_t left = size_ - begin;
  const std::string where = "cut short at byte " + std::to_string(begin);
  if (const auto event = header_at(begin)) {
    return where + ": an event of " + std::to_string(event->end - begin) + " bytes, of which " +
           std::to_string(left) + " are there";
  }
  std::vector<std::byte> rest(std::min(left, kHeaderBytes));
  const bool is_header =
      left < kHeaderBytes && read(begin, rest) && begins_with(rest, kLogMark.substr(0, left));
  return is_header ? where + ": within an event's header" : "";
}

void EventFinder::note_gap(std::uint64_t begin, std::uint64_t end) {
  if (end == size_) cut_ = describe_cut(begin);
  if (!cut_.empty()) return;
  if (damages_++ == 0) first_damage_ = begin;
  damaged_bytes_ += end - begin;
}

std::optional<EventPlace> EventFinder::next() {
  while (at_ < size_) {
    const std::uint64_t begin = at_;
    const std::optional<EventPlace> here = header_at(begin);
    if (here && is_followed_well(*here)) {
      at_ = here->end;
      return here;
    }
    const std::optional<EventPlace> behind = find_from(begin + 1);
    at_ = behind ? behind->begin : size_;
    // If another event begins within an event, that event has a wrong length.
    const bool is_whole = here && here->end <= at_;
    note_gap(is_whole ? here->end : begin, at_);
    if (is_whole) return here;
  }
  return std::nullopt;
}

std::optional<std::string> EventFinder::defect() const {
  std::string text;
  if (damages_ > 0) {
    text = "damaged at byte " + std::to_string(first_damage_);
    if (damages_ > 1) text += " and in " + std::to_string(damages_ - 1) + " more places";
    text += ": " + std::to_string(damaged_bytes_) +
            " bytes are no event; all events before and behind are used; copy the log again";
  }
  if (!cut_.empty()) {
    text += (text.empty() ? "" : "; ") + cut_ +
            "; the events before it are used; wait if it is being written, else copy it again";
  }
  return text.empty() ? std::nullopt : std::optional(text);
}

}  // namespace quadrille::bus
