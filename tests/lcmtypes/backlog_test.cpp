#include "link/backlog.hpp"

#include "support/catch.hpp"

namespace quadrille::bus {
namespace {

constexpr std::size_t kSize = 1000;
constexpr std::size_t kRoomForThree = 3 * (kSize + Backlog::kOverhead);

std::vector<std::byte> numbered(int number) {
  return std::vector<std::byte>(kSize, static_cast<std::byte>(number));
}

std::vector<int> numbers_left(Backlog& backlog) {
  std::vector<int> numbers;
  while (const auto message = backlog.pop()) {
    numbers.push_back(std::to_integer<int>(message->bytes.at(kSize - 1)));
  }
  return numbers;
}

TEST_CASE("a backlog keeps the order and drives out the oldest", "[bus][backlog]") {
  Backlog backlog(kRoomForThree);
  int subscriber = 0;
  for (int i = 1; i <= 60; ++i) backlog.push("CLOUDS", numbered(i), &subscriber);
  CHECK(backlog.dropped() == 57);
  CHECK(numbers_left(backlog) == std::vector<int>{58, 59, 60});
  CHECK(backlog.empty());
  // What was taken makes room.
  for (int i = 1; i <= 3; ++i) backlog.push("CLOUDS", numbered(i), &subscriber);
  CHECK(backlog.dropped() == 57);
}

TEST_CASE("a flood on one channel drives nothing of another out", "[bus][backlog]") {
  Backlog backlog(kRoomForThree);
  int clouds = 0, requests = 0;
  backlog.push("REQUESTS", numbered(100), &requests);
  for (int i = 1; i <= 60; ++i) backlog.push("CLOUDS", numbered(i), &clouds);
  backlog.push("REQUESTS", numbered(101), &requests);
  CHECK(numbers_left(backlog) == std::vector<int>{100, 58, 59, 60, 101});
}

TEST_CASE("of one subscriber's channels a fast one does not drive out a slow one's",
          "[bus][backlog]") {
  Backlog backlog(kRoomForThree);
  int cameras = 0;
  backlog.push("SLOW", numbered(100), &cameras);
  for (int i = 1; i <= 60; ++i) backlog.push("FAST", numbered(i), &cameras);
  CHECK(backlog.dropped() == 58);
  CHECK(numbers_left(backlog) == std::vector<int>{100, 59, 60});
  // Any number of channels has no more room than one.
  for (int i = 1; i <= 60; ++i) backlog.push("C" + std::to_string(i), numbered(i), &cameras);
  CHECK(numbers_left(backlog).size() == 3);
}

TEST_CASE("the newest message waits however large it is", "[bus][backlog]") {
  Backlog backlog(10);
  int subscriber = 0;
  backlog.push("CLOUDS", numbered(1), &subscriber);
  backlog.push("CLOUDS", numbered(2), &subscriber);
  CHECK(numbers_left(backlog) == std::vector<int>{2});
}

}  // namespace
}  // namespace quadrille::bus
