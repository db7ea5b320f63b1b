#include "view/live/live_questions.hpp"

#include <algorithm>
#include <random>
#include <stdexcept>
#include <utility>
#include <variant>

#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/grasps_message.hpp"
#include "quadrille/bus/request_message.hpp"
#include "run/clock.hpp"

namespace quadrille::view {
namespace {

/// Returns one of 2^52 numbers, so that two viewers on one bus do not take each other's answers.
std::int64_t random_number() {
  std::random_device device;
  const std::uint64_t bits = (std::uint64_t{device()} << 32) | device();
  return static_cast<std::int64_t>(bits >> 12);
}

grasp_request_t request_of(const Question& question, std::int64_t number) {
  grasp_request_t request{};
  request.utime = bus::wall_clock_utime();
  request.request_id = number;
  request.min_clearance = question.min_clearance;
  request.advise = true;
  if (question.track > 0) {
    request.tracks = {question.track};
    request.num_tracks = 1;
  } else {
    request.cloud_utime = question.cloud_utime;
    request.targets = {question.target};
    request.num_targets = 1;
  }
  return request;
}

}  // namespace

LiveQuestions::LiveQuestions(bus::Connection& connection, std::string channel,
                             std::chrono::milliseconds min_memory)
    : connection_(connection),
      channel_(std::move(channel)),
      min_memory_(min_memory),
      last_number_(random_number()) {}

std::int64_t LiveQuestions::ask(const Question& question) {
  std::int64_t number = 0;
  {
    const auto now = std::chrono::steady_clock::now();
    const std::lock_guard lock(mutex_);
    if (asked_.size() == kMaxRemembered) {
      if (now - asked_.front().when < min_memory_) {
        throw TooManyQuestions("too many questions; wait some seconds, and ask again");
      }
      asked_.pop_front();
    }
    number = ++last_number_;
    asked_.push_back({number, now, nullptr});
  }
  connection_.publish(channel_, bus::encode(request_of(question, number)));
  return number;
}

bool LiveQuestions::take(std::span<const std::byte> bytes) {
  const std::lock_guard lock(mutex_);
  if (asked_.empty()) return false;
  const auto decoded = bus::decode_grasps(bytes, kMaxAnswerBytes);
  const auto* const grasps = std::get_if<grasps_t>(&decoded);
  Asked* const asked = grasps != nullptr ? find(grasps->request_id) : nullptr;
  if (asked == nullptr) return false;
  asked->answer = std::make_shared<const std::vector<std::byte>>(bytes.begin(), bytes.end());
  came_.notify_all();
  return true;
}

Bytes LiveQuestions::wait(std::int64_t number, std::chrono::milliseconds timeout) {
  std::unique_lock lock(mutex_);
  const auto is_over = [&] {
    const Asked* const asked = find(number);
    return asked == nullptr || asked->answer;
  };
  came_.wait_for(lock, timeout, is_over);
  const Asked* const asked = find(number);
  if (asked == nullptr) throw std::out_of_range("there is no such question; ask again");
  return asked->answer;
}

LiveQuestions::Asked* LiveQuestions::find(std::int64_t number) {
  const auto found = std::find_if(asked_.begin(), asked_.end(),
                                  [&](const Asked& asked) { return asked.number == number; });
  return found == asked_.end() ? nullptr : &*found;
}

}  // namespace quadrille::view
