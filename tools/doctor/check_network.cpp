#include "doctor/check_network.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "doctor/multicast.hpp"
#include "link/network.hpp"

namespace quadrille::doctor {
namespace {

constexpr const char* kMendRoute =
    "sudo ip link set lo up && sudo ip route add 224.0.0.0/4 dev lo (other machines are reached by "
    "another interface than lo)";

/// Returns the ttl of an address that has passed check_live().
int ttl_of(const bus::Url& url) {
  const auto found = url.arguments.find("ttl");
  return found == url.arguments.end() ? 0 : std::stoi(found->second);
}

std::string mebibytes(std::int64_t bytes) {
  return fmt::format("{:.1f} MiB", static_cast<double>(bytes) / (1 << 20));
}

}  // namespace

Finding check_address(const bus::Url& url) {
  const std::string text = url.to_string();
  try {
    bus::check_live(url);
  } catch (const std::invalid_argument& error) {
    return {Verdict::kFailed, "address", error.what(), kMendAddress};
  }
  if (url.provider == "mpudpm") {
    return {
        Verdict::kWarning, "address",
        fmt::format("{}: its receive buffers are those of the kernel, and its datagrams are not "
                    "guarded",
                    text),
        kMendAddress};
  }
  if (url.provider == "udpm") return {Verdict::kOk, "address", text};
  return {Verdict::kOk, "address",
          fmt::format("{}, through a server: nothing is lost, but a slow listener holds up all "
                      "senders",
                      text)};
}

Finding check_route(const bus::Url& url) {
  const sockaddr_in group = bus::multicast_group(url);
  if (const auto out = interface_to(group)) {
    return {Verdict::kOk, "route", fmt::format("{} is reached by {}", to_text(group), out->name)};
  }
  return {Verdict::kFailed, "route",
          fmt::format("no route to the multicast group {}", to_text(group)), kMendRoute};
}

Finding check_interface(const bus::Url& url) {
  const auto out = interface_to(bus::multicast_group(url));
  if (!out) return {Verdict::kFailed, "interface", "none leads to the group", kMendRoute};
  const bool leaves = ttl_of(url) > 0;
  const std::string what = fmt::format("{}, as {}", out->name, out->address);
  if (out->is_loopback && leaves) {
    return {Verdict::kFailed, "interface",
            fmt::format("{}: no other machine will hear anything, though ttl asks for it", what),
            "sudo ip route replace 224.0.0.0/4 dev INTERFACE, with one of: ip -brief link"};
  }
  // Linux delivers to itself over lo whatever the interface's multicast flag says.
  if (!out->is_loopback && !out->can_multicast) {
    return {Verdict::kFailed, "interface", fmt::format("{}: it carries no multicast", what),
            fmt::format("sudo ip link set {} multicast on", out->name)};
  }
  return {Verdict::kOk, "interface", what};
}

Finding check_ttl(const bus::Url& url) {
  const int ttl = ttl_of(url);
  if (ttl == 0) return {Verdict::kOk, "ttl", "0: messages stay on this machine"};
  if (ttl == 1) return {Verdict::kOk, "ttl", "1: messages reach all of the local network"};
  return {Verdict::kWarning, "ttl", fmt::format("{}: messages may cross {} routers", ttl, ttl - 1),
          "ttl=1 in the LCM address, unless other networks are meant"};
}

Buffers buffers_of(const bus::Url& url) {
  const int asked = bus::named_receive_buffer(url).value_or(bus::kMaxReceiveBufferBytes);
  return {asked, bus::forced_receive_buffer(asked), bus::granted_receive_buffer(asked)};
}

Finding check_buffers(const Buffers& buffers, std::int64_t cloud_bytes, const std::string& source) {
  Finding finding{Verdict::kOk, "buffers",
                  fmt::format("{} for clouds of {} ({})", mebibytes(buffers.granted),
                              mebibytes(cloud_bytes), source)};
  const std::int64_t needed = bus::needed_receive_buffer(cloud_bytes);
  if (buffers.unprivileged >= needed) return finding;
  finding.verdict = Verdict::kWarning;
  finding.remedy =
      bus::mend_receive_buffer(buffers.asked, bus::advised_receive_buffer(cloud_bytes));
  if (buffers.granted >= needed) {
    finding.what += fmt::format("; processes without CAP_NET_ADMIN, which this one has, get {}",
                                mebibytes(buffers.unprivileged));
  } else if (buffers.granted >= cloud_bytes) {
    finding.what += ": two in a row do not fit";
  } else if (2 * std::int64_t{buffers.granted} >= cloud_bytes) {
    // The kernel grants as much again for its bookkeeping, which large datagrams hardly need.
    finding.what += ": those that come while the receiver is busy may be lost";
  } else {
    finding.verdict = Verdict::kFailed;
    finding.what += ": not one fits whole";
  }
  return finding;
}

}  // namespace quadrille::doctor
