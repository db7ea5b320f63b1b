#include "log/event_log.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string_view>

#include "log/event_finder.hpp"
#include "quadrille/bus/cloud_message.hpp"

namespace quadrille::bus {
namespace {

std::string describe_write_failure() {
  return std::string("cannot be written (") + std::strerror(errno) +
         "); check the folder and the space left";
}

LogSurvey survey_log(const std::string& path) {
  EventFinder finder(path);
  LogSurvey survey;
  while (finder.next()) ++survey.events;
  survey.defect = finder.defect();
  return survey;
}

}  // namespace

bool starts_as_log(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, 4> start{};
  file.read(start.data(), start.size());
  return file && std::string_view(start.data(), start.size()) == kLogMark;
}

void check_different_files(const std::string& in_log, const std::string& out_log) {
  std::error_code error;
  if (std::filesystem::equivalent(in_log, out_log, error)) {
    throw std::runtime_error(out_log +
                             ": is both the log to read and the log to write; name another one");
  }
}

LogReader::LogReader(const std::string& path)
    : survey_(survey_log(path)), finder_(std::make_unique<EventFinder>(path)) {}

LogReader::~LogReader() = default;

std::optional<LogReader::Event> LogReader::next() {
  if (read_ == survey_.events) return std::nullopt;
  const std::optional<EventPlace> place = finder_->next();
  if (place) event_.resize(place->end - place->begin);
  if (!place || !finder_->read(place->begin, event_)) {
    survey_.defect = "cut short while it was read: after " + std::to_string(read_) + " of " +
                     std::to_string(survey_.events) + " events";
    return std::nullopt;
  }
  ++read_;
  const std::span<const std::byte> data = std::span(event_).last(place->data_bytes);
  const char* const channel = reinterpret_cast<const char*>(data.data()) - place->channel_bytes;
  return Event{place->utime, {channel, place->channel_bytes}, data};
}

LogWriter::LogWriter(const std::string& path, const std::string& name)
    : name_(name.empty() ? path : name), file_(std::make_unique<lcm::LogFile>(path, "w")) {
  if (!file_->good()) fail();
}

void LogWriter::fail() {
  if (failure_.empty()) failure_ = describe_write_failure();
  throw std::runtime_error(name_ + ": " + failure_);
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
