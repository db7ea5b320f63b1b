#include "process/merger/shard_watch.hpp"

#include <fmt/format.h>

#include <utility>

namespace quadrille {

std::string to_string(InOrder::State state) {
  switch (state) {
    case InOrder::State::kUnheard:
      return "unheard";
    case InOrder::State::kWorks:
      return "works";
    case InOrder::State::kSilent:
      return "silent";
    case InOrder::State::kStuck:
      return "stuck";
  }
  return "";
}

ShardWatch::ShardWatch(int shard, int shards, std::string channel)
    : name_(fmt::format("shard {}/{}", shard, shards)), channel_(std::move(channel)) {}

std::optional<std::string> ShardWatch::update(InOrder::State state,
                                              std::optional<Clock::time_point> others_heard_since,
                                              Clock::time_point now) {
  const bool was_lost = is_lost_;
  state_ = state;
  is_lost_ = state == InOrder::State::kUnheard
                 ? others_heard_since && now - *others_heard_since >= kStart
                 : state != InOrder::State::kWorks;
  if (is_lost_ == was_lost) return std::nullopt;
  if (is_lost_) {
    ++times_lost_;
    is_told_ = log_.admit(now).has_value();
    return is_told_ ? describe() : std::nullopt;
  }
  if (!std::exchange(is_told_, false)) return std::nullopt;
  return fmt::format("{} is back", name_);
}

std::optional<std::string> ShardWatch::describe() const {
  if (!is_lost_) return std::nullopt;
  const std::string since = "its share of the clouds is missing, and nobody waits for it";
  switch (state_) {
    case InOrder::State::kUnheard:
      return fmt::format(
          "{} was not heard on {} yet while others are; {}: start its detector, or look at its "
          "network with quadrille doctor",
          name_, channel_, since);
    case InOrder::State::kStuck:
      return fmt::format(
          "{} takes clouds and does not answer them in time; {}: it has too much to do, or its "
          "--patience is too short",
          name_, since);
    default:
      return fmt::format(
          "{} is silent on {} while others speak; {}: look whether its detector runs, and at its "
          "network with quadrille doctor",
          name_, channel_, since);
  }
}

}  // namespace quadrille
