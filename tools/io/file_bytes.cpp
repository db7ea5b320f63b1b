#include "io/file_bytes.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "quadrille/detector/printable.hpp"

namespace quadrille::io {

FileError::FileError(const std::string& path, const std::string& where, const std::string& what)
    : std::runtime_error(printable(path, kMaxPath) + ": " +
                         (where.empty() ? "" : printable(where) + ": ") +
                         printable(what, kMaxLine - kMaxPath)) {}

std::vector<std::byte> read_file(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) {
    throw FileError(path, "", "no such file; check the path");
  }
  if (!std::filesystem::is_regular_file(status)) {
    throw FileError(path, "", "not a regular file; give the path of a file");
  }
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  std::ifstream in(path, std::ios::binary);
  if (error || !in) {
    throw FileError(
        path, "",
        std::string("cannot be read (") + std::strerror(errno) + "); check its permissions");
  }
  std::vector<std::byte> bytes(size);
  in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  return bytes;
}

std::vector<std::byte> read_standard_input() {
  constexpr std::size_t kMaxBytes = std::size_t{1} << 31, kPiece = 1 << 20;
  std::vector<std::byte> bytes;
  for (std::size_t got = kPiece; got == kPiece;) {
    const std::size_t before = bytes.size();
    if (before > kMaxBytes) {
      throw FileError("standard input", "", "is more than 2 GiB; thin the cloud out");
    }
    bytes.resize(before + kPiece);
    got = std::fread(bytes.data() + before, 1, kPiece, stdin);
    bytes.resize(before + got);
  }
  return bytes;
}

}  // namespace quadrille::io
