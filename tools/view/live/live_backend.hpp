#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "link/connection.hpp"
#include "link/receiver.hpp"
#include "view/backend.hpp"
#include "view/live/live_questions.hpp"
#include "view/live/live_scene.hpp"

namespace quadrille::view {

/// Shows what comes over the bus. Scenes are made from the newest messages, and only while a
/// browser is looking; a slow browser misses scenes. Nothing is published unless a user asks the
/// planner.
class LiveBackend : public Backend {
 public:
  /// @param allow_requests  true if the page may ask the planner
  /// @throws std::runtime_error if the bus cannot be reached
  LiveBackend(const std::string& url, const LiveChannels& channels, FindGripper find_gripper,
              bool allow_requests, const PackLimits& limits = {});
  ~LiveBackend() override;

  io::Json session() override;
  Pack frame(std::size_t, const PlanChoice&) override { return nullptr; }
  Pack newest() override;
  std::uint64_t wait_newer(std::uint64_t version, std::chrono::milliseconds timeout) override;
  io::Json status() override;
  std::int64_t ask(const Question& question) override;
  io::Json wait_answer(std::int64_t number, std::chrono::milliseconds timeout) override;

  /// Throws the error that ended the connection, if one did.
  void check() override { receiver_->check(); }

 private:
  void make_scenes();
  void subscribe();

  MessageKeeper keeper_;
  FindGripper find_gripper_;
  PackLimits limits_;
  bool allow_requests_;
  bus::Connection connection_;
  LiveQuestions questions_;
  std::mutex mutex_;
  std::condition_variable made_;
  Pack newest_;
  std::uint64_t version_ = 0;
  std::atomic<bool> stop_{false};
  std::thread maker_;
  std::optional<bus::Receiver> receiver_;
};

}  // namespace quadrille::view
