#pragma once

#include <string>

namespace quadrille::view {

/// Tells requests of people at this machine from such as web pages elsewhere make their browsers
/// send.
class RequestGuard {
 public:
  /// @param bind_address  where the server listens; on all but the loopback address each address
  ///                      that is a number is right, for whoever reaches it has been let in
  explicit RequestGuard(const std::string& bind_address);

  /// True if a request names this machine. A name that an attacker's DNS brings here does not.
  bool allows_host(const std::string& host) const;
  /// True if a request comes from the page itself, or from no page (an empty origin).
  /// @param host  that of the same request
  bool allows_origin(const std::string& origin, const std::string& host) const;

 private:
  bool loopback_only_;
};

/// True for an address by which only this machine is reached.
bool is_loopback(const std::string& address);

}  // namespace quadrille::view
