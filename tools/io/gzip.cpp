#include "io/gzip.hpp"

// This makes zlib accept const input.
#define ZLIB_CONST
#include <zlib.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "io/file_bytes.hpp"

namespace quadrille::io {
namespace {

constexpr std::size_t kMaxBytes = std::size_t{1} << 31, kPiece = 1 << 20;
// Added to the window size, this makes zlib read and write gzip's header.
constexpr int kGzip = 16;

/// zlib's state for decompression, freed on destruction.
struct Inflater {
  Inflater() { inflateInit2(&stream, MAX_WBITS + kGzip); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  ~Inflater() { inflateEnd(&stream); }

  z_stream stream{};
};

/// zlib's state for compression, freed on destruction.
struct Deflater {
  Deflater() {
    constexpr int kMemoryLevel = 8;
    deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, MAX_WBITS + kGzip, kMemoryLevel,
                 Z_DEFAULT_STRATEGY);
  }
  Deflater(const Deflater&) = delete;
  Deflater& operator=(const Deflater&) = delete;
  ~Deflater() { deflateEnd(&stream); }

  z_stream stream{};
};

}  // namespace

bool is_gzip(std::span<const std::byte> bytes) {
  return bytes.size() > 2 && bytes[0] == std::byte{0x1f} && bytes[1] == std::byte{0x8b};
}

std::vector<std::byte> gunzip(std::span<const std::byte> bytes, const std::string& name) {
  if (bytes.size() > std::numeric_limits<uInt>::max()) {
    throw FileError(name, "", "is larger than 4 GiB; unpack it first");
  }
  Inflater inflater;
  z_stream& stream = inflater.stream;
  stream.next_in = reinterpret_cast<const Bytef*>(bytes.data());
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::vector<std::byte> unpacked;
  for (int state = Z_OK; state != Z_STREAM_END;) {
    const std::size_t before = unpacked.size();
    if (before + kPiece > kMaxBytes) {
      throw FileError(name, "", "holds more than 2 GiB; unpack it, or thin it out");
    }
    unpacked.resize(before + kPiece);
    stream.next_out = reinterpret_cast<Bytef*>(unpacked.data() + before);
    stream.avail_out = kPiece;
    state = inflate(&stream, Z_NO_FLUSH);
    unpacked.resize(before + kPiece - stream.avail_out);
    if (state != Z_OK && state != Z_STREAM_END) {
      throw FileError(name, "byte " + std::to_string(stream.total_in),
                      "the gzip data is damaged or cut short; copy the file again");
    }
  }
  return unpacked;
}

std::string gzip(std::string_view bytes) {
  if (bytes.size() > std::numeric_limits<uInt>::max()) throw std::length_error("more than 4 GiB");
  Deflater deflater;
  z_stream& stream = deflater.stream;
  std::string packed(deflateBound(&stream, bytes.size()), '\0');
  stream.next_in = reinterpret_cast<const Bytef*>(bytes.data());
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  return packed;
}

}  // namespace quadrille::io
