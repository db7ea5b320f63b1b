#pragma once

#include <string>
#include <string_view>

namespace quadrille::view {

/// Bytes as base64 (RFC 4648), padded.
std::string base64(std::string_view bytes);

/// How a content security policy names a script or a style that stands in the page:
/// "'sha256-…'".
std::string policy_hash(std::string_view text);

}  // namespace quadrille::view
