#include "link/network.hpp"

#include <nlohmann/json.hpp>

#include "doctor/check_network.hpp"
#include "doctor/check_poses.hpp"
#include "doctor/report.hpp"
#include "support/catch.hpp"

namespace quadrille::doctor {
namespace {

constexpr int kStock = 212992;

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

Finding judge(int granted, int unprivileged, std::int64_t cloud_bytes) {
  return check_buffers({bus::kMaxReceiveBufferBytes, granted, unprivileged}, cloud_bytes, "told");
}

TEST_CASE("buffers are judged by what this process gets", "[doctor]") {
  CHECK(judge(kStock, kStock, kStock / 2).verdict == Verdict::kOk);
  CHECK(judge(kStock, kStock, kStock).verdict == Verdict::kWarning);
  // Large datagrams may fill what the kernel adds for its bookkeeping; whether they do shows the
  // round trip.
  CHECK(judge(kStock, kStock, 2 * kStock).verdict == Verdict::kWarning);
  CHECK(judge(kStock, kStock, 2 * kStock + 1).verdict == Verdict::kFailed);
  // With CAP_NET_ADMIN its own messages come; others are warned.
  const Finding forced = judge(128 << 20, kStock, bus::kUsualCloudBytes);
  CHECK(forced.verdict == Verdict::kWarning);
  CHECK(holds(forced.what, "without CAP_NET_ADMIN, which this one has, get 0.2 MiB"));
}

TEST_CASE("doctor and processes advise the same buffer", "[doctor]") {
  const std::string remedy = judge(kStock, kStock, bus::kUsualCloudBytes).remedy;
  CHECK(remedy == bus::mend_receive_buffer(bus::kMaxReceiveBufferBytes, bus::kReceiveBufferBytes));
}

TEST_CASE("addresses that cannot work are told as the processes tell them", "[doctor]") {
  for (const std::string url :
       {"memq://", "pigeon://", "udpm://10.0.0.1:7667", "udpm://?ttl=300"}) {
    CAPTURE(url);
    const Finding found = check_address(bus::parse_url(url));
    CHECK(found.verdict == Verdict::kFailed);
    CHECK_THROWS_WITH(bus::check_live(bus::parse_url(url)), found.what);
  }
  CHECK(check_address(bus::parse_url("udpm://")).verdict == Verdict::kOk);
  CHECK(check_address(bus::parse_url("mpudpm://")).verdict == Verdict::kWarning);
}

TEST_CASE("one warning is not several", "[doctor]") {
  const Finding warning{Verdict::kWarning, "ttl", "2", "1"},
      failed{Verdict::kFailed, "a", "b", "c"};
  CHECK(holds(to_table({warning}), "clouds will arrive (1 warning)"));
  CHECK(holds(to_table({warning, failed, warning}), "1 failed, 2 warnings"));
}

TEST_CASE("if only poses fail, clouds arrive all the same", "[doctor][pose]") {
  const Finding poses = check_poses({}).front(), network{Verdict::kFailed, "route", "none", "add"};
  REQUIRE(poses.verdict == Verdict::kFailed);
  CHECK(holds(to_table({poses}),
              "\nclouds will arrive, but not all of them will get the pose of their camera: 1 "
              "failed, 0 warnings\n"));
  CHECK(to_json("udpm://", {poses})["clouds_will_arrive"] == true);
  CHECK(holds(to_table({poses, network}), "\nnot all clouds will arrive: 2 failed"));
  CHECK(to_json("udpm://", {poses, network})["clouds_will_arrive"] == false);
}

}  // namespace
}  // namespace quadrille::doctor
