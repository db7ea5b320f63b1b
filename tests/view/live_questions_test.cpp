#include "view/live/live_questions.hpp"

#include <stdexcept>
#include <variant>

#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/grasps_message.hpp"
#include "quadrille/bus/request_message.hpp"
#include "support/catch.hpp"

using namespace quadrille;
using namespace std::chrono_literals;

namespace {

/// Questions on a bus of this process, and the last request that was published there.
struct Bus {
  bus::Connection connection{"memq://"};
  view::LiveQuestions questions;
  grasp_request_t request{};

  explicit Bus(std::chrono::milliseconds min_memory = 0ms)
      : questions(connection, "ASK", min_memory) {
    connection.subscribe("ASK", [this](const std::string&, std::span<const std::byte> bytes) {
      request = std::get<grasp_request_t>(bus::decode_request(bytes));
    });
  }

  std::int64_t ask(const view::Question& question) {
    const std::int64_t number = questions.ask(question);
    REQUIRE(connection.handle(1000) == bus::Connection::Outcome::kHandled);
    return number;
  }
};

std::vector<std::byte> answer_to(std::int64_t request_id) {
  grasps_t message{};
  message.request_id = request_id;
  message.gripper = "franka";
  return bus::encode(message);
}

}  // namespace

TEST_CASE("a question goes out as a request, by track or else by id and cloud",
          "[view][requests]") {
  Bus bus;
  view::Question question;
  question.track = 4;
  question.target = 2;
  question.cloud_utime = 77;
  question.min_clearance = 0.005;
  const std::int64_t number = bus.ask(question);
  CHECK(bus.request.request_id == number);
  CHECK(bus.request.tracks == std::vector<std::int32_t>{4});
  CHECK(bus.request.targets.empty());
  CHECK(bus.request.cloud_utime == 0);
  CHECK(bus.request.min_clearance == 0.005);
  question.track = 0;
  CHECK(bus.ask(question) != number);
  CHECK(bus.request.targets == std::vector<std::int32_t>{2});
  CHECK(bus.request.tracks.empty());
  CHECK(bus.request.cloud_utime == 77);
}

TEST_CASE("numbers of questions can be held by JavaScript", "[view][requests]") {
  for (int i = 0; i < 100; ++i) {
    bus::Connection connection("memq://");
    const std::int64_t number = view::LiveQuestions(connection, "ASK").ask({});
    CHECK(number > 0);
    CHECK(number < (std::int64_t{1} << 53));
  }
}

TEST_CASE("answers to what was asked here are kept, all others are not", "[view][requests]") {
  Bus bus;
  view::Question question;
  question.track = 1;
  CHECK_FALSE(bus.questions.take(answer_to(0)));
  const std::int64_t number = bus.ask(question);
  CHECK(bus.questions.wait(number, 1ms) == nullptr);
  CHECK_FALSE(bus.questions.take(answer_to(0)));
  CHECK_FALSE(bus.questions.take(answer_to(number + 1)));
  CHECK_FALSE(bus.questions.take(std::vector<std::byte>(40)));
  CHECK(bus.questions.take(answer_to(number)));
  const view::Bytes answer = bus.questions.wait(number, 1s);
  REQUIRE(answer);
  CHECK(std::get<grasps_t>(bus::decode_grasps(*answer)).request_id == number);
  CHECK_THROWS_AS(bus.questions.wait(number + 1, 1ms), std::out_of_range);
}

TEST_CASE("a page cannot flood the planner with questions", "[view][requests][hostile]") {
  Bus bus(1h);
  view::Question question;
  question.track = 1;
  const std::int64_t first = bus.ask(question);
  for (std::size_t i = 1; i < view::LiveQuestions::kMaxRemembered; ++i) bus.ask(question);
  CHECK_THROWS_AS(bus.questions.ask(question), view::TooManyQuestions);
  CHECK(bus.connection.handle(0) == bus::Connection::Outcome::kTimeout);
  // What was asked before is still answered.
  CHECK(bus.questions.take(answer_to(first)));
}

TEST_CASE("no more questions are remembered than there are places", "[view][requests]") {
  Bus bus;
  view::Question question;
  question.track = 1;
  const std::int64_t first = bus.ask(question);
  for (std::size_t i = 0; i < view::LiveQuestions::kMaxRemembered; ++i) bus.ask(question);
  CHECK_THROWS_AS(bus.questions.wait(first, 1ms), std::out_of_range);
  CHECK_FALSE(bus.questions.take(answer_to(first)));
}
