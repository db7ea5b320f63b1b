#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>

#include "doctor/check_poses.hpp"
#include "doctor/check_traffic.hpp"
#include "doctor/traffic.hpp"

/// Whatever is sent to the group, the doctor counts it and judges it. The first byte of each
/// datagram says how long it is, the second who sent it.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace quadrille::doctor;
  Traffic traffic;
  PoseRecorder poses("POSE", "POINT_CLOUD", 0);
  std::int64_t now = 1, datagrams = 0;
  for (std::size_t at = 0; at + 2 <= size;) {
    const std::size_t length = std::min<std::size_t>(data[at], size - at - 2);
    const std::string sender(1, static_cast<char>('a' + data[at + 1] % 4));
    const auto datagram = std::as_bytes(std::span(data + at + 2, length));
    traffic.add(sender, datagram, now += 1000);
    poses.add(sender, datagram, now);
    ++datagrams;
    at += 2 + length;
  }
  check_clouds(traffic, "POINT_CLOUD", 1.0);
  check_losses(traffic, 7667);
  check_others(traffic, "POINT_CLOUD");
  check_clocks(traffic, now);
  if (check_poses(poses.heard(now)).empty()) std::abort();
  if (traffic.malformed() + traffic.crowded_out() > datagrams) std::abort();
  return 0;
}
