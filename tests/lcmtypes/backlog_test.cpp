#include "quadrille/bus/backlog.hpp"

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

TEST_CASE("the newest message waits however large it is", "[bus][backlog]") {
  Backlog backlog(10);
  int subscriber = 0;
  backlog.push("CLOUDS", numbered(1), &subscriber);
  backlog.push("CLOUDS", numbered(2), &subscriber);
  CHECK(numbers_left(backlog) == std::vector<int>{2});
}

}  // namespace
}  // namespace quadrille::bus
