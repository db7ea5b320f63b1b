#include "doctor/round_trip.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstring>
#include <set>
#include <thread>
#include <vector>

#include "link/connection.hpp"
#include "run/clock.hpp"

namespace quadrille::doctor {
namespace {

using Clock = std::chrono::steady_clock;

/// Records which messages of a trip were received, and after what time.
class Arrivals {
 public:
  explicit Arrivals(std::size_t messages) : sent_(messages), latencies_(messages) {}

  void note_sent(std::size_t number) { sent_[number] = Clock::now(); }

  void note_arrival(std::span<const std::byte> bytes) {
    std::uint64_t number = 0;
    if (bytes.size() < sizeof number) return;
    std::memcpy(&number, bytes.data(), sizeof number);
    if (number >= sent_.size() || !came_.insert(number).second) return;
    latencies_.add(bus::ms_since(sent_[number]));
  }

  TripResult result() const {
    return {static_cast<int>(sent_.size()), static_cast<int>(came_.size()), latencies_.summary()};
  }
  bool all_came() const { return came_.size() == sent_.size(); }

 private:
  std::vector<Clock::time_point> sent_;
  std::set<std::uint64_t> came_;
  bus::Durations latencies_;
};

/// Handles messages until a time, or until all have come.
void handle_until(Clock::time_point end, const Arrivals& arrivals, bus::Connection& connection) {
  for (;;) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now()).count();
    if (left <= 0 || arrivals.all_came()) return;
    connection.handle(static_cast<int>(left));
  }
}

}  // namespace

TripResult make_trip(bus::Url url, const Trip& trip) {
  if (url.provider == "udpm") url.arguments.insert_or_assign("ttl", std::string(1, '0'));
  constexpr std::chrono::seconds kPatience{2};
  const std::string channel = fmt::format("QUADRILLE_DOCTOR_{}", getpid());
  Arrivals arrivals(static_cast<std::size_t>(trip.messages));
  bus::Connection in(url.to_string()), out(url.to_string());
  in.subscribe(channel, [&](const std::string&, std::span<const std::byte> bytes) {
    arrivals.note_arrival(bytes);
  });
  std::vector<std::byte> message(std::max(trip.bytes, sizeof(std::uint64_t)));
  for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(trip.messages); ++i) {
    std::memcpy(message.data(), &i, sizeof i);
    arrivals.note_sent(i);
    out.publish(channel, message);
    handle_until(Clock::now() + trip.interval, arrivals, in);
  }
  handle_until(Clock::now() + kPatience, arrivals, in);
  return arrivals.result();
}

Finding check_trip(const std::string& check, const Trip& trip, const TripResult& result,
                   const std::string& buffers) {
  Finding finding{
      Verdict::kOk, check,
      fmt::format("{} of {} messages of {} bytes came, after {:.2f} ms (half of them), {:.2f} ms "
                  "at the most",
                  result.came, result.sent, trip.bytes, result.latency.p50, result.latency.max)};
  if (result.came == result.sent) return finding;
  finding.verdict = Verdict::kFailed;
  if (result.came == 0) {
    finding.what = fmt::format("none of {} messages of {} bytes came", result.sent, trip.bytes);
  }
  finding.remedy = !buffers.empty()
                       ? buffers
                       : "sudo nft list ruleset, and let UDP of the group pass; with no such rule "
                         "the machine is too busy: look at top";
  return finding;
}

}  // namespace quadrille::doctor
