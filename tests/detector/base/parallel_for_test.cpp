#include "quadrille/detector/parallel_for.hpp"

#include <atomic>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "support/catch.hpp"

using quadrille::parallel_for;

TEST_CASE("each task runs once, whatever the number of threads", "[parallel]") {
  for (const int threads : {1, 2, 5, 40}) {
    std::vector<std::atomic<int>> runs(23);
    parallel_for(23, threads, [&](int k) { ++runs[static_cast<std::size_t>(k)]; });
    for (const auto& n : runs) CHECK(n == 1);
  }
}

TEST_CASE("no tasks, no calls", "[parallel][degenerate]") {
  int calls = 0;
  parallel_for(0, 4, [&](int) { ++calls; });
  parallel_for(-3, 4, [&](int) { ++calls; });
  CHECK(calls == 0);
}

TEST_CASE("one thread runs all tasks itself, in order", "[parallel]") {
  std::vector<int> order;
  const std::thread::id self = std::this_thread::get_id();
  parallel_for(5, 1, [&](int k) {
    order.push_back(k);
    CHECK(std::this_thread::get_id() == self);
  });
  CHECK(order == std::vector<int>{0, 1, 2, 3, 4});
}

TEST_CASE("two tasks on two threads run at the same time", "[parallel]") {
  std::atomic<int> arrived = 0;
  parallel_for(2, 2, [&](int) {
    ++arrived;
    while (arrived < 2) std::this_thread::yield();
  });
  CHECK(arrived == 2);
}

TEST_CASE("the exception of the lowest task is rethrown and the other tasks still run",
          "[parallel]") {
  for (const int threads : {1, 3}) {
    std::atomic<int> runs = 0;
    const auto task = [&](int k) {
      ++runs;
      if (k == 4 || k == 7) throw std::runtime_error("task " + std::to_string(k));
    };
    CHECK_THROWS_WITH(parallel_for(10, threads, task), "task 4");
    CHECK(runs == 10);
  }
}
