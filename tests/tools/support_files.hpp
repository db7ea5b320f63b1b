#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <type_traits>

namespace quadrille::test {

/// A folder that lives as long as the object.
class TempFolder {
 public:
  TempFolder();
  ~TempFolder();
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;

  /// Path of a file in the folder.
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  /// Writes a file and returns its path.
  std::string write(const std::string& name, const std::string& content) const;

 private:
  std::filesystem::path folder_;
};

/// The whole content of a file.
std::string content_of(const std::string& path);

/// What a run of the quadrille command left behind.
struct Run {
  int code = 0;
  std::string out, err;
};

/// Runs the built quadrille command through the shell.
Run run_quadrille(const std::string& arguments);

/// The message that a call throws as std::runtime_error; empty if it throws nothing.
std::string error_of(const std::function<void()>& call);

inline std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text));
}

/// Appends the bytes of a number, least significant first or last.
template <class Number>
requires std::is_arithmetic_v<Number>
void put(std::string* to, Number value, bool big_endian = false) {
  const char* raw = reinterpret_cast<const char*>(&value);
  std::string bytes(raw, sizeof value);
  if (big_endian) bytes.assign(bytes.rbegin(), bytes.rend());
  *to += bytes;
}

}  // namespace quadrille::test
