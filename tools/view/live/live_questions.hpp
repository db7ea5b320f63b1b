#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <span>
#include <string>

#include "link/connection.hpp"
#include "view/live/latest_messages.hpp"
#include "view/live/question.hpp"

namespace quadrille::view {

/// Puts questions to the planner on the bus and keeps the latest answers until they are fetched.
class LiveQuestions {
 public:
  /// Limits of the number of remembered questions, and of the bytes of their answers [byte].
  static constexpr std::size_t kMaxRemembered = 16, kMaxAnswerBytes = std::size_t{4} << 20;
  /// Each question is remembered at least for this time, in which no more than kMaxRemembered can
  /// be asked.
  static constexpr std::chrono::milliseconds kMinMemory{5000};

  /// @param connection  connection on which requests are published; must outlive this object
  /// @param channel  channel of the requests
  LiveQuestions(bus::Connection& connection, std::string channel,
                std::chrono::milliseconds min_memory = kMinMemory);

  /// Publishes one request.
  /// @return its request_id, from 1 to 2^53, which JavaScript can represent exactly
  /// @throws TooManyQuestions if kMaxRemembered questions were asked within the last min_memory
  std::int64_t ask(const Question& question);

  /// Keeps a message of type grasps_t if it answers a question of this viewer.
  /// @return true if the message is such an answer
  bool take(std::span<const std::byte> bytes);

  /// Waits for an answer, or until a timeout; null if there is none yet.
  /// @throws std::out_of_range if the question is unknown, or was forgotten because it is too old
  Bytes wait(std::int64_t number, std::chrono::milliseconds timeout);

 private:
  struct Asked {
    std::int64_t number;
    std::chrono::steady_clock::time_point when;
    Bytes answer;
  };

  Asked* find(std::int64_t number);

  bus::Connection& connection_;
  std::string channel_;
  std::chrono::milliseconds min_memory_;
  std::mutex mutex_;
  std::condition_variable came_;
  /// The remembered questions, the oldest first.
  std::deque<Asked> asked_;
  /// The last request number. It starts at a random one, because others ask over the same bus.
  std::int64_t last_number_;
};

}  // namespace quadrille::view
