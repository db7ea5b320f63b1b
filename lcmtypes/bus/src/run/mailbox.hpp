#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

namespace quadrille::bus {

/// Hands items from a thread that receives to a thread that works. A slot holds one item, and a
/// newer one replaces it; there may be several named slots, which are emptied in the order in which
/// they were filled. A short queue holds items that are not replaced. If both hold items, they are
/// taken in turns.
template <class T>
class Mailbox {
 public:
  /// Puts an item into the slot of that name; an item that was not taken yet is dropped and
  /// counted. Each name makes a slot, and the caller must bound their number.
  void put(T item, const std::string& slot = "") {
    // An item may be large, so the old one is destroyed after the lock is released.
    std::optional<T> dropped;
    {
      const std::lock_guard lock(mutex_);
      const auto found = std::find_if(slots_.begin(), slots_.end(),
                                      [&](const auto& filled) { return filled.first == slot; });
      if (found == slots_.end()) {
        slots_.emplace_back(slot, std::move(item));
      } else {
        dropped = std::exchange(found->second, std::move(item));
        ++superseded_;
      }
    }
    filled_.notify_one();
  }

  /// Largest number of items in the queue.
  static constexpr std::size_t kMaxQueued = 64;

  /// Puts an item into the queue; returns false and does nothing if the queue is full.
  bool queue(T item) {
    {
      const std::lock_guard lock(mutex_);
      if (queue_.size() >= kMaxQueued) return false;
      queue_.push_back(std::move(item));
    }
    filled_.notify_one();
    return true;
  }

  /// Takes an item, waiting for one until the timeout; nullopt if none came.
  std::optional<T> take(std::chrono::milliseconds timeout) {
    std::unique_lock lock(mutex_);
    filled_.wait_for(lock, timeout, [this] { return !slots_.empty() || !queue_.empty(); });
    if (!queue_.empty() && !(from_queue_ && !slots_.empty())) {
      from_queue_ = true;
      T item = std::move(queue_.front());
      queue_.pop_front();
      return item;
    }
    from_queue_ = false;
    if (slots_.empty()) return std::nullopt;
    T item = std::move(slots_.front().second);
    slots_.pop_front();
    return item;
  }

  /// Number of items replaced by a newer one so far.
  std::int64_t superseded() const {
    const std::lock_guard lock(mutex_);
    return superseded_;
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable filled_;
  /// The filled slots by name.
  std::deque<std::pair<std::string, T>> slots_;
  std::deque<T> queue_;
  /// True if the last item was taken from the queue.
  bool from_queue_ = false;
  std::int64_t superseded_ = 0;
};

}  // namespace quadrille::bus
