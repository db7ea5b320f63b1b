#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>

namespace quadrille::bus {

/// A slot for one item between a thread that receives and a thread that works: the newest wins.
/// Beside it a short queue for items that no other replaces. Where both hold something they are
/// taken in turns.
template <class T>
class Mailbox {
 public:
  /// Puts an item in; one that was not yet taken is dropped and counted.
  void put(T item) {
    // An item may be large: the old one dies after the lock is given back.
    std::optional<T> dropped(std::move(item));
    {
      const std::lock_guard lock(mutex_);
      slot_.swap(dropped);
      if (dropped) ++superseded_;
    }
    filled_.notify_one();
  }

  /// Items that may wait in the queue.
  static constexpr std::size_t kMaxQueued = 64;

  /// Puts an item into the queue; false, and nothing done, if that is full.
  bool queue(T item) {
    {
      const std::lock_guard lock(mutex_);
      if (queue_.size() >= kMaxQueued) return false;
      queue_.push_back(std::move(item));
    }
    filled_.notify_one();
    return true;
  }

  /// Takes an item, waiting for one for as long as the timeout; nullopt if none came.
  std::optional<T> take(std::chrono::milliseconds timeout) {
    std::unique_lock lock(mutex_);
    filled_.wait_for(lock, timeout, [this] { return slot_.has_value() || !queue_.empty(); });
    if (!queue_.empty() && !(from_queue_ && slot_)) {
      from_queue_ = true;
      T item = std::move(queue_.front());
      queue_.pop_front();
      return item;
    }
    from_queue_ = false;
    return std::exchange(slot_, std::nullopt);
  }

  /// Items dropped for a newer one so far.
  std::int64_t superseded() const {
    const std::lock_guard lock(mutex_);
    return superseded_;
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable filled_;
  std::optional<T> slot_;
  std::deque<T> queue_;
  /// Whether the last item came from the queue.
  bool from_queue_ = false;
  std::int64_t superseded_ = 0;
};

}  // namespace quadrille::bus
