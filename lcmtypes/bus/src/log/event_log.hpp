#pragma once

#include <cstddef>
#include <cstdint>
#include <lcm/lcm-cpp.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace quadrille::bus {

class EventFinder;

/// Information from the headers of a log's events, read without their data.
struct LogSurvey {
  /// Number of complete events.
  std::int64_t events = 0;
  /// Describes bytes that are no event and what to do about them: "cut short at byte N: …" at the
  /// end of the log, "damaged at byte N: …" elsewhere; nullopt if all bytes are events.
  std::optional<std::string> defect;
};

/// True if a file begins like an LCM log, regardless of its name; false if it cannot be read.
bool starts_as_log(const std::string& path);

/// Refuses an output log that is also the input log, since opening it would empty the input.
/// @throws std::runtime_error naming the file
void check_different_files(const std::string& in_log, const std::string& out_log);

/// Reads the complete events of a log in order, whatever bytes their channels' names have (LCM's
/// file provider skips names that are not UTF-8). Behind damaged bytes it continues at the next
/// event that is followed by another event or by the end of the file.
class LogReader {
 public:
  /// @throws std::runtime_error naming the file if it is missing, cannot be read or is not an LCM
  /// log
  explicit LogReader(const std::string& path);
  ~LogReader();

  /// Returns the survey made before the first event was read; its defect is also set if the log was
  /// truncated since then.
  const LogSurvey& survey() const { return survey_; }

  /// One event, whose data are valid until the next one is read.
  struct Event {
    /// Time at which the event was logged [us].
    std::int64_t utime = 0;
    std::string channel;
    std::span<const std::byte> bytes;
  };

  /// Returns the next event; nullopt at the end.
  std::optional<Event> next();

 private:
  LogSurvey survey_;
  std::int64_t read_ = 0;
  std::unique_ptr<EventFinder> finder_;
  std::vector<std::byte> event_;
};

/// Writes a log that lcm-logplayer and file:// can play.
class LogWriter {
 public:
  /// @param name  name for error messages; if empty, the path
  /// @throws std::runtime_error if the file cannot be created
  explicit LogWriter(const std::string& path, const std::string& name = "");

  /// Appends one event.
  /// @param utime    the event's time [us]
  /// @param channel  any name of 1 to 999 bytes, since a copied log keeps the names of its source
  /// @throws std::invalid_argument if the channel's name has another length or the message is too
  ///   large
  /// @throws std::runtime_error if this or an earlier event could not be written
  void write(std::int64_t utime, const std::string& channel, std::span<const std::byte> bytes);

  /// Flushes all events to the system, so that a full disk is noticed.
  /// @throws std::runtime_error if that fails, or an event could not be written
  void flush();

 private:
  [[noreturn]] void fail();

  std::string name_;
  /// The first failure. Nothing is written after it, since an event after a gap would not be found.
  std::string failure_;
  std::unique_ptr<lcm::LogFile> file_;
};

}  // namespace quadrille::bus
