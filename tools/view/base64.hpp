#pragma once

#include <string>
#include <string_view>

namespace quadrille::view {

/// Encodes bytes as base64 (RFC 4648), padded.
std::string base64(std::string_view bytes);

/// Returns the form in which a content security policy names an inline script or style:
/// "'sha256-…'".
std::string policy_hash(std::string_view text);

}  // namespace quadrille::view
