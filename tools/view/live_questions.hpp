#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <span>
#include <string>

#include "quadrille/bus/connection.hpp"
#include "view/latest_messages.hpp"
#include "view/question.hpp"

namespace quadrille::view {

/// Puts questions to the planner on the bus and keeps the last answers until they are fetched.
class LiveQuestions {
 public:
  /// Questions that are remembered at most, and of their answers the most bytes [byte].
  static constexpr std::size_t kMaxRemembered = 16, kMaxAnswerBytes = std::size_t{4} << 20;
  /// For so long at least each question is remembered: no more than that many can be asked in it.
  static constexpr std::chrono::milliseconds kMinMemory{5000};

  /// @param connection  publishes; must outlive this
  /// @param channel     of the requests
  LiveQuestions(bus::Connection& connection, std::string channel,
                std::chrono::milliseconds min_memory = kMinMemory);

  /// Publishes one request.
  /// @return its request_id: from 1 to 2^53, so that JavaScript can hold it
  /// @throws TooManyQuestions if as many as are remembered were asked just before
  std::int64_t ask(const Question& question);

  /// Keeps a message of type grasps_t if it answers a question of here.
  /// @return true if it does
  bool take(std::span<const std::byte> bytes);

  /// Waits for an answer, and at most so long; null if there is none yet.
  /// @throws std::out_of_range if that was not asked, or so long ago that it is forgotten
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
  /// The oldest first.
  std::deque<Asked> asked_;
  /// Where the numbers of here begin: others ask over the same bus.
  std::int64_t last_number_;
};

}  // namespace quadrille::view
