#pragma once

#include <string>

namespace quadrille::view {

/// Distinguishes requests of people at this machine from those that web pages elsewhere make their
/// browsers send.
class RequestGuard {
 public:
  /// @param bind_address  address on which the server listens; unless it is the loopback address,
  ///                      every numeric address is accepted, since whoever can reach it was let in
  explicit RequestGuard(const std::string& bind_address);

  /// Returns true if the request names this machine. This rejects names that an attacker's DNS
  /// resolves to it.
  bool allows_host(const std::string& host) const;
  /// Returns true if a request comes from the page itself, or from no page (an empty origin).
  /// @param host  the host named in the same request
  bool allows_origin(const std::string& origin, const std::string& host) const;

 private:
  bool loopback_only_;
};

/// Returns true for an address that only this machine can reach.
bool is_loopback(const std::string& address);

}  // namespace quadrille::view
