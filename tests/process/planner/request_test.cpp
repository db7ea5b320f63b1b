// Requests for grasps and their answers.
#include <algorithm>
#include <chrono>
#include <map>
#include <thread>

#include "process/planner/asked_planner.hpp"

namespace quadrille {
namespace {

using namespace test;

TEST_CASE("a request is answered with its id by what it asks for", "[process][request]") {
  Asked asked("--on-request");
  asked.show(1000);
  CHECK(asked.answers.empty());
  const grasps_t all = asked.ask(request_of(5));
  CHECK(all.utime == 1000);
  CHECK(all.frame == "eye");
  CHECK(targets_of(all).size() >= 3);
  grasp_request_t request = request_of(6);
  request.targets = {a_sphere().id};
  request.num_targets = 1;
  request.max_grasps = 2;
  const grasps_t one = asked.ask(request);
  CHECK(targets_of(one) == std::set{a_sphere().id});
  CHECK(one.grasps.size() == 2);
  // Nothing but the grasps is sent.
  CHECK(asked.channels.count("GRASPS") == asked.channels.size());
  const planner_status_t status = asked.status();
  CHECK(status.requests == 2);
  CHECK(status.answered == 2);
  CHECK(status.unmet == 0);
}

TEST_CASE("each cloud is planned on as well unless told otherwise", "[process][request]") {
  Asked asked;
  asked.show(1000);
  REQUIRE(asked.answers.size() == 1);
  CHECK(asked.answers[0].request_id == 0);
  const grasps_t same = asked.ask(request_of(1));
  REQUIRE(same.grasps.size() == asked.answers[0].grasps.size());
  for (std::size_t n = 0; n < same.grasps.size(); ++n) {
    CHECK(same.grasps[n].score == asked.answers[0].grasps[n].score);
  }
}

TEST_CASE("an older cloud can be named, and one that is gone is told of", "[process][request]") {
  Asked asked("--on-request");
  CHECK(asked.ask(request_of(1)).warnings.at(0) == "no cloud has come with its quadrics yet");
  for (std::int64_t utime = 1; utime <= 40; ++utime) asked.show(utime);
  CHECK(asked.ask(request_of(2)).utime == 40);
  grasp_request_t request = request_of(3);
  request.cloud_utime = 20;
  CHECK(asked.ask(request).utime == 20);
  request.cloud_utime = 2;
  const grasps_t gone = asked.ask(request);
  CHECK(gone.grasps.empty());
  CHECK(gone.warnings.at(0).find("cloud 2 is not kept") == 0);
  CHECK(asked.status().unmet == 2);
}

TEST_CASE("a request that cannot be met is answered with the reason", "[process][request]") {
  Asked asked("--on-request");
  asked.show(1000);
  const auto why = [&](const grasp_request_t& request) {
    const grasps_t answer = asked.ask(request);
    CHECK(answer.grasps.empty());
    REQUIRE_FALSE(answer.warnings.empty());
    return answer.warnings.back();
  };
  grasp_request_t request = request_of(1);
  request.targets = {99};
  request.num_targets = 1;
  CHECK(why(request).find("no target of that id; there are:") == 0);
  request = request_of(2);
  request.types = {"teapot"};
  request.num_types = 1;
  CHECK(why(request) == "types: 'teapot' is no type");
  request = request_of(3);
  request.has_approach = 1;
  CHECK(why(request) == "approach: must not be 0");
  request = request_of(4);
  request.has_region = 1;
  CHECK(why(request).find("region.quaternion has norm 0") == 0);
  request = request_of(5);
  request.min_clearance = std::numeric_limits<double>::quiet_NaN();
  CHECK(why(request).find("min_clearance") == 0);
}

TEST_CASE("damaged requests are counted and answered by nothing", "[process][request][hostile]") {
  Asked asked("--on-request");
  asked.show(1000);
  Bytes bytes = bus::encode(request_of(1));
  bytes.pop_back();
  asked.give("GRASP_REQUEST", bytes);
  CHECK(asked.answers.empty());
  asked.give("GRASP_REQUEST", bus::encode(request_of(0)));
  CHECK(asked.answers.empty());
  const planner_status_t status = asked.status();
  CHECK(status.requests == 2);
  REQUIRE(status.rejected_requests.size() == 2);
  for (const count_t& rejected : status.rejected_requests) CHECK(rejected.count == 1);
}

TEST_CASE("requests are jobs that no newer one replaces", "[process][request]") {
  Asked asked("--on-request");
  asked.show(1000);
  const auto job = asked.node().receive("GRASP_REQUEST", bus::encode(request_of(8)));
  REQUIRE(job);
  REQUIRE(job->refuse);
  job->refuse("the queue is full");
  REQUIRE(asked.answers.size() == 1);
  CHECK(asked.answers[0].request_id == 8);
  CHECK(asked.answers[0].warnings.at(0) == "the queue is full");
}

}  // namespace
}  // namespace quadrille
