#include "io/new_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "io/file_bytes.hpp"

namespace quadrille::io {
namespace {

namespace fs = std::filesystem;

/// Resolves links, so that a link stays a link when its file is replaced.
std::string follow_links(const std::string& path) {
  std::error_code error;
  const fs::path real = fs::canonical(path, error);
  return error ? path : real.string();
}

}  // namespace

NewFile::NewFile(const std::string& target) : target_(follow_links(target)) {
  std::error_code error;
  const fs::file_status status = fs::status(target_, error);
  const bool direct = fs::exists(status) && !fs::is_regular_file(status);
  path_ = direct ? target_ : target_ + ".part" + std::to_string(getpid());
  if (std::ofstream(path_, std::ios::app)) return;
  throw FileError(target, "",
                  std::string("cannot be created (") + std::strerror(errno) +
                      "); check the folder and its permissions");
}

NewFile::~NewFile() {
  std::error_code ignored;
  if (!committed_ && path_ != target_) fs::remove(path_, ignored);
}

void NewFile::write(std::span<const std::byte> bytes) {
  std::ofstream out(path_, std::ios::binary | std::ios::trunc);
  out.write(reinterpret_cast<const char*>(bytes.data()),
            static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (out) return;
  throw FileError(target_, "",
                  std::string("cannot be written (") + std::strerror(errno) +
                      "); check the folder, its permissions and the space left");
}

void NewFile::commit() {
  std::error_code error;
  if (path_ != target_) fs::rename(path_, target_, error);
  if (error) throw FileError(target_, "", "cannot be replaced (" + error.message() + ")");
  committed_ = true;
}

void write_file(const std::string& path, std::span<const std::byte> bytes) {
  NewFile file(path);
  file.write(bytes);
  file.commit();
}

void write_file(const std::string& path, const std::string& text) {
  write_file(path, std::as_bytes(std::span(text)));
}

}  // namespace quadrille::io
