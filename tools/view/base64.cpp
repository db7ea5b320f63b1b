#include "view/base64.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>
#include <openssl/sha.h>

#include <array>

namespace quadrille::view {
namespace {

const unsigned char* begin_of(std::string_view bytes) {
  return reinterpret_cast<const unsigned char*>(bytes.data());
}

}  // namespace

std::string base64(std::string_view bytes) {
  // OpenSSL's lengths are of type int, and it encodes three bytes at a time.
  constexpr std::size_t kPart = 3 << 20;
  std::string text;
  for (std::size_t at = 0; at < bytes.size(); at += kPart) {
    const std::string_view part = bytes.substr(at, kPart);
    // The encoder terminates its text with a zero.
    std::string encoded((part.size() + 2) / 3 * 4 + 1, '\0');
    EVP_EncodeBlock(reinterpret_cast<unsigned char*>(encoded.data()), begin_of(part),
                    static_cast<int>(part.size()));
    encoded.pop_back();
    text += encoded;
  }
  return text;
}

std::string policy_hash(std::string_view text) {
  std::array<unsigned char, SHA256_DIGEST_LENGTH> hash{};
  SHA256(begin_of(text), text.size(), hash.data());
  return fmt::format("'sha256-{}'",
                     base64({reinterpret_cast<const char*>(hash.data()), hash.size()}));
}

}  // namespace quadrille::view
