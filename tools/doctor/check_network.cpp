#include "doctor/check_network.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>

#include "doctor/multicast.hpp"
#include "quadrille/bus/network.hpp"

namespace quadrille::doctor {
namespace {

constexpr const char* kMendRoute =
    "sudo ip link set lo up && sudo ip route add 224.0.0.0/4 dev lo (other machines are reached by "
    "another interface than lo)";

std::optional<int> number_in(const std::string& text) {
  int value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || rest != end) return std::nullopt;
  return value;
}

/// Argument of the address as a number; nullopt if it is none.
std::optional<int> argument(const bus::Url& url, const std::string& key, int without) {
  const auto found = url.arguments.find(key);
  return found == url.arguments.end() ? without : number_in(found->second);
}

std::string mebibytes(std::size_t bytes) {
  return fmt::format("{:.1f} MiB", static_cast<double>(bytes) / (1 << 20));
}

/// The commands that give a process buffers of so many bytes.
std::string mend_buffers(const Buffers& buffers, std::size_t wanted) {
  std::string commands;
  // Asked for more than any cloud needs, the kernel grants what it allows.
  if (static_cast<std::size_t>(bus::granted_receive_buffer(1 << 30)) < wanted) {
    const std::string setting = fmt::format("net.core.rmem_max={}", wanted);
    commands = fmt::format(
        "sudo sysctl -w {} (and to keep it: echo {} | sudo tee /etc/sysctl.d/60-lcm.conf)", setting,
        setting);
  }
  if (static_cast<std::size_t>(buffers.asked) < wanted) {
    commands += fmt::format("{}recv_buf_size={} in the LCM address of all processes",
                            commands.empty() ? "" : ", and ", wanted);
  }
  return fmt::format("{}; then start all processes anew", commands);
}

/// A power of two of bytes that holds four such clouds.
std::size_t wanted_buffer(std::size_t cloud_bytes) {
  std::size_t wanted = bus::kReceiveBufferBytes;
  constexpr std::size_t kMax = std::size_t{1} << 30;
  while (wanted < kMax && wanted < 4 * cloud_bytes) wanted *= 2;
  return wanted;
}

}  // namespace

Finding check_address(const bus::Url& url) {
  const std::string text = url.to_string();
  if (url.provider == "udpm") return {Verdict::kOk, "address", text};
  if (url.provider == "tcpq") {
    return {Verdict::kOk, "address",
            fmt::format("{}, through a server: nothing is lost, but a slow listener holds up all "
                        "senders",
                        text)};
  }
  return {Verdict::kFailed, "address", fmt::format("{} reaches no other process", text),
          "--lcm-url udpm://239.255.76.67:7667?ttl=0, or unset LCM_DEFAULT_URL"};
}

Finding check_route(const bus::Url& url) {
  const sockaddr_in group = group_of(url);
  if (!IN_MULTICAST(ntohl(group.sin_addr.s_addr))) {
    return {Verdict::kFailed, "route", fmt::format("{} is no multicast address", to_text(group)),
            "--lcm-url udpm://239.255.76.67:7667?ttl=0"};
  }
  if (const auto out = interface_to(group)) {
    return {Verdict::kOk, "route", fmt::format("{} is reached by {}", to_text(group), out->name)};
  }
  return {Verdict::kFailed, "route",
          fmt::format("no route to the multicast group {}", to_text(group)), kMendRoute};
}

Finding check_interface(const bus::Url& url) {
  const auto out = interface_to(group_of(url));
  if (!out) return {Verdict::kFailed, "interface", "none leads to the group", kMendRoute};
  const bool leaves = argument(url, "ttl", 0).value_or(0) > 0;
  const std::string what = fmt::format("{}, as {}", out->name, out->address);
  if (out->is_loopback && leaves) {
    return {Verdict::kFailed, "interface",
            fmt::format("{}: no other machine will hear anything, though ttl asks for it", what),
            "sudo ip route replace 224.0.0.0/4 dev INTERFACE, with one of: ip -brief link"};
  }
  // Linux delivers to itself over lo whatever its flag says.
  if (!out->is_loopback && !out->can_multicast) {
    return {Verdict::kFailed, "interface", fmt::format("{}: it carries no multicast", what),
            fmt::format("sudo ip link set {} multicast on", out->name)};
  }
  return {Verdict::kOk, "interface", what};
}

Finding check_ttl(const bus::Url& url) {
  const auto ttl = argument(url, "ttl", 0);
  if (!ttl || *ttl < 0 || *ttl > 255) {
    return {Verdict::kFailed, "ttl",
            fmt::format("ttl={} in the LCM address is no number from 0 to 255",
                        url.arguments.at("ttl")),
            "ttl=0 for this machine, ttl=1 for its network"};
  }
  if (*ttl == 0) return {Verdict::kOk, "ttl", "0: messages stay on this machine"};
  if (*ttl == 1) return {Verdict::kOk, "ttl", "1: messages reach all of the local network"};
  return {Verdict::kWarning, "ttl",
          fmt::format("{}: messages may cross {} routers", *ttl, *ttl - 1),
          "ttl=1 in the LCM address, unless other networks are meant"};
}

Buffers buffers_of(const bus::Url& url) {
  const int asked = argument(url, "recv_buf_size", bus::kReceiveBufferBytes).value_or(0);
  return {asked, bus::granted_receive_buffer(asked)};
}

Finding check_buffers(const Buffers& buffers, std::size_t cloud_bytes, const std::string& source) {
  const auto granted = static_cast<std::size_t>(std::max(buffers.granted, 0));
  Finding finding{
      Verdict::kOk, "buffers",
      fmt::format("{} for clouds of {} ({})", mebibytes(granted), mebibytes(cloud_bytes), source)};
  if (granted >= 2 * cloud_bytes) return finding;
  finding.remedy = mend_buffers(buffers, wanted_buffer(cloud_bytes));
  if (granted >= cloud_bytes) {
    finding.verdict = Verdict::kWarning;
    finding.what += ": two in a row do not fit";
  } else {
    finding.verdict = Verdict::kFailed;
    finding.what += ": not one fits whole, most will be lost";
  }
  return finding;
}

}  // namespace quadrille::doctor
