#include "quadrille/bus/event_log.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "quadrille/bus/cloud_message.hpp"

namespace quadrille::bus {
namespace {

/// Before each event: magic, number (8), time (8), length of the channel's name, length of the
/// data.
constexpr std::uint64_t kHeaderBytes = 28;
constexpr std::uint32_t kMagic = 0xEDA1DA01;
/// LCM's own reader refuses longer names.
constexpr std::uint32_t kMaxChannelBytes = 999;

struct Header {
  std::uint32_t magic = 0, channel_bytes = 0, data_bytes = 0;
};

std::uint32_t load_big_endian(const unsigned char* from) {
  return std::uint32_t{from[0]} << 24 | std::uint32_t{from[1]} << 16 | std::uint32_t{from[2]} << 8 |
         std::uint32_t{from[3]};
}

Header read_header(std::ifstream& file, std::uint64_t offset) {
  std::array<unsigned char, kHeaderBytes> raw{};
  file.seekg(static_cast<std::streamoff>(offset));
  file.read(reinterpret_cast<char*>(raw.data()), raw.size());
  return {load_big_endian(&raw[0]), load_big_endian(&raw[20]), load_big_endian(&raw[24])};
}

[[noreturn]] void fail(const std::string& path, const std::string& what) {
  throw std::runtime_error(path + ": " + what);
}

std::string describe_write_failure() {
  return std::string("cannot be written (") + std::strerror(errno) +
         "); check the folder and the space left";
}

/// Lengths that no LCM process writes: the log is damaged, not cut short.
void check_lengths(const std::string& path, std::uint64_t offset, const Header& header,
                   std::uint64_t left) {
  const bool absurd_data = header.data_bytes >= std::numeric_limits<std::int32_t>::max() ||
                           (header.data_bytes > kMaxMessageBytes && header.data_bytes > left);
  if (header.channel_bytes == 0 || header.channel_bytes > kMaxChannelBytes || absurd_data) {
    fail(path, "damaged at byte " + std::to_string(offset) + ": an event with a channel name of " +
                   std::to_string(header.channel_bytes) + " and data of " +
                   std::to_string(header.data_bytes) + " bytes; record the log anew");
  }
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

LogSurvey survey_log(const std::string& path) {
  const std::uint64_t size = size_of(path);
  std::ifstream file(path, std::ios::binary);
  if (!file) fail(path, std::string(std::strerror(errno)) + "; check its permissions");
  LogSurvey survey;
  std::uint64_t offset = 0;
  while (offset < size) {
    const std::uint64_t left = size - offset;
    if (left < kHeaderBytes && offset > 0) {
      survey.defect = "cut short at byte " + std::to_string(offset) + ": within an event's header";
      return survey;
    }
    const Header header = read_header(file, offset);
    if (header.magic != kMagic) {
      if (offset == 0)
        fail(path, "is not an LCM log (no event at byte 0); give one that lcm-logger recorded");
      survey.defect = "damaged at byte " + std::to_string(offset) + ": no event there";
      return survey;
    }
    check_lengths(path, offset, header, left - std::min(left, kHeaderBytes));
    const std::uint64_t event_bytes =
        kHeaderBytes + std::uint64_t{header.channel_bytes} + header.data_bytes;
    if (event_bytes > left) {
      survey.defect = "cut short at byte " + std::to_string(offset) + ": an event of " +
                      std::to_string(event_bytes) + " bytes, of which " + std::to_string(left) +
                      " are there";
      return survey;
    }
    ++survey.events;
    offset += event_bytes;
  }
  return survey;
}

bool starts_as_log(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return file && read_header(file, 0).magic == kMagic;
}

void check_different_files(const std::string& in_log, const std::string& out_log) {
  std::error_code error;
  if (std::filesystem::equivalent(in_log, out_log, error)) {
    fail(out_log, "is both the log to read and the log to write; name another one");
  }
}

LogReader::LogReader(const std::string& path) : survey_(survey_log(path)) {
  file_ = std::make_unique<lcm::LogFile>(path, "r");
  if (!file_->good()) fail(path, "cannot be read; check its permissions");
}

std::optional<LogReader::Event> LogReader::next() {
  if (read_ == survey_.events) return std::nullopt;
  const lcm::LogEvent* event = file_->readNextEvent();
  if (event == nullptr) {
    survey_.defect = "cut short while it was read: after " + std::to_string(read_) + " of " +
                     std::to_string(survey_.events) + " events";
    return std::nullopt;
  }
  ++read_;
  return Event{
      event->timestamp,
      event->channel,
      {static_cast<const std::byte*>(event->data), static_cast<std::size_t>(event->datalen)}};
}

LogWriter::LogWriter(const std::string& path, const std::string& name)
    : name_(name.empty() ? path : name), file_(std::make_unique<lcm::LogFile>(path, "w")) {
  if (!file_->good()) fail();
}

void LogWriter::fail() {
  if (failure_.empty()) failure_ = describe_write_failure();
  bus::fail(name_, failure_);
}

void LogWriter::write(std::int64_t utime, const std::string& channel,
                      std::span<const std::byte> bytes) {
  if (channel.empty() || channel.size() > kMaxChannelBytes) {
    throw std::invalid_argument("channel: a name of " + std::to_string(channel.size()) + " bytes");
  }
  if (bytes.size() > kMaxMessageBytes) {
    throw std::invalid_argument("a message of " + std::to_string(bytes.size()) +
                                " bytes is too large for LCM");
  }
  lcm::LogEvent event;
  event.eventnum = 0;
  event.timestamp = utime;
  event.channel = channel;
  event.datalen = static_cast<std::int32_t>(bytes.size());
  event.data = const_cast<std::byte*>(bytes.data());
  if (!failure_.empty() || file_->writeEvent(&event) != 0) fail();
}

void LogWriter::flush() {
  if (!failure_.empty() || std::fflush(file_->getFilePtr()) != 0) fail();
}

}  // namespace quadrille::bus
