#include "run/mailbox.hpp"

#include <memory>
#include <thread>

#include "support/catch.hpp"

namespace quadrille::bus {
namespace {

using std::chrono::milliseconds;

TEST_CASE("the newest item wins and the others are counted", "[bus][mailbox]") {
  Mailbox<int> mailbox;
  for (int i = 1; i <= 5; ++i) mailbox.put(i);
  CHECK(mailbox.superseded() == 4);
  CHECK(mailbox.take(milliseconds(0)) == 5);
  CHECK(mailbox.take(milliseconds(0)) == std::nullopt);
  mailbox.put(6);
  CHECK(mailbox.take(milliseconds(0)) == 6);
  CHECK(mailbox.superseded() == 4);
}

TEST_CASE("the newest item of each slot wins, and the slots have their turns", "[bus][mailbox]") {
  Mailbox<int> mailbox;
  mailbox.put(1, "A");
  mailbox.put(11, "B");
  // However fast one is filled, the other is not starved.
  for (int i = 2; i <= 5; ++i) mailbox.put(i, "A");
  CHECK(mailbox.take(milliseconds(0)) == 5);
  mailbox.put(6, "A");
  CHECK(mailbox.take(milliseconds(0)) == 11);
  CHECK(mailbox.take(milliseconds(0)) == 6);
  CHECK(mailbox.take(milliseconds(0)) == std::nullopt);
  CHECK(mailbox.superseded() == 4);
}

TEST_CASE("what is queued is not replaced, and comes in turns with what is", "[bus][mailbox]") {
  Mailbox<int> mailbox;
  mailbox.put(1);
  CHECK(mailbox.queue(11));
  CHECK(mailbox.queue(12));
  mailbox.put(2);
  for (const int item : {11, 2, 12}) CHECK(mailbox.take(milliseconds(0)) == item);
  CHECK(mailbox.superseded() == 1);
  for (std::size_t i = 0; i < mailbox.kMaxQueued; ++i) CHECK(mailbox.queue(0));
  CHECK_FALSE(mailbox.queue(0));
}

TEST_CASE("an item that comes while someone waits is taken", "[bus][mailbox]") {
  Mailbox<std::unique_ptr<int>> mailbox;
  std::thread sender([&] { mailbox.put(std::make_unique<int>(7)); });
  const auto item = mailbox.take(milliseconds(10000));
  sender.join();
  REQUIRE(item);
  CHECK(**item == 7);
}

TEST_CASE("every item is either taken or counted as superseded", "[bus][mailbox]") {
  constexpr int kItems = 20000;
  Mailbox<int> mailbox;
  std::thread sender([&] {
    for (int i = 1; i <= kItems; ++i) mailbox.put(i);
  });
  int taken = 0, last = 0;
  while (last != kItems) {
    const auto item = mailbox.take(milliseconds(10000));
    REQUIRE(item);
    REQUIRE(*item > last);
    last = *item;
    ++taken;
  }
  sender.join();
  CHECK(taken + mailbox.superseded() == kItems);
}

}  // namespace
}  // namespace quadrille::bus
