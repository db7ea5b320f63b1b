#pragma once

#include <cstddef>
#include <cstdint>
#include <lcm/lcm-cpp.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "quadrille/detector/export.hpp"

namespace quadrille::bus {

class EventFinder;

/// What the headers of a log's events say, read without their data.
struct LogSurvey {
  /// Whole events.
  std::int64_t events = 0;
  /// Which bytes are no event and what to do, "cut short at byte N: …" at the end of the log,
  /// "damaged at byte N: …" elsewhere; nullopt if all bytes are events.
  std::optional<std::string> defect;
};

/// Walks over the events of a log. Behind damaged bytes it goes on where an event begins that is
/// followed by another one, or by the end of the file.
/// @throws std::runtime_error naming the file if it is missing, cannot be read or is not an LCM log
QUADRILLE_EXPORT LogSurvey survey_log(const std::string& path);

/// True if a file begins as LCM logs do, whatever its name; false if it cannot be read.
QUADRILLE_EXPORT bool starts_as_log(const std::string& path);

/// Refuses an output log that is the input log too: opening it would empty the input.
/// @throws std::runtime_error naming the file
QUADRILLE_EXPORT void check_different_files(const std::string& in_log, const std::string& out_log);

/// Reads the whole events of a log in order.
class LogReader {
 public:
  /// @throws std::runtime_error as survey_log() does
  QUADRILLE_EXPORT explicit LogReader(const std::string& path);
  QUADRILLE_EXPORT ~LogReader();

  /// What the headers said before the first event was read; its defect also tells of a log that
  /// was cut short since then.
  const LogSurvey& survey() const { return survey_; }

  /// One event; its data lives until the next one is read.
  struct Event {
    /// When the event was logged [us].
    std::int64_t utime = 0;
    std::string channel;
    std::span<const std::byte> bytes;
  };

  /// The next event; nullopt at the end.
  QUADRILLE_EXPORT std::optional<Event> next();

 private:
  LogSurvey survey_;
  std::int64_t read_ = 0;
  std::unique_ptr<EventFinder> finder_;
  std::vector<std::byte> event_;
};

/// Writes a log that lcm-logplayer and file:// play.
class LogWriter {
 public:
  /// @param name  what errors call it; empty: the path
  /// @throws std::runtime_error if the file cannot be made
  QUADRILLE_EXPORT explicit LogWriter(const std::string& path, const std::string& name = "");

  /// Appends one event.
  /// @param utime    the event's time [us]
  /// @param channel  any name of 1 to 999 bytes: a copied log keeps those of its source
  /// @throws std::invalid_argument if the channel's name has no such length or the message is too
  ///   large
  /// @throws std::runtime_error if it cannot be written, or an event before could not
  QUADRILLE_EXPORT void write(std::int64_t utime, const std::string& channel,
                              std::span<const std::byte> bytes);

  /// Hands all to the system, so that a full disk does not go unnoticed.
  /// @throws std::runtime_error if that fails, or an event could not be written
  QUADRILLE_EXPORT void flush();

 private:
  [[noreturn]] void fail();

  std::string name_;
  /// What went wrong; an event after a gap would not be found.
  std::string failure_;
  std::unique_ptr<lcm::LogFile> file_;
};

}  // namespace quadrille::bus
