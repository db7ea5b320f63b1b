#include "io/npy/npz.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <zip.h>

#include <algorithm>
#include <memory>
#include <string_view>
#include <vector>

#include "io/file_bytes.hpp"
#include "io/npy/npy.hpp"
#include "quadrille/detector/printable.hpp"

namespace quadrille::io {
namespace {

constexpr std::size_t kMaxBytes = std::size_t{1} << 31, kPiece = 1 << 20;
constexpr std::string_view kViewpoint = "viewpoint.npy";

using Part = std::unique_ptr<zip_file_t, decltype(&zip_fclose)>;

/// A zip file in memory.
class Archive {
 public:
  Archive(std::span<const std::byte> bytes, const std::string& name)
      : name_(name), zip_(nullptr, &zip_discard) {
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
    if (source != nullptr) zip_.reset(zip_open_from_source(source, ZIP_RDONLY, &error));
    // An archive that was opened owns its source.
    if (!zip_ && source != nullptr) zip_source_free(source);
    zip_error_fini(&error);
    if (!zip_) throw FileError(name, "", "is a damaged .npz file; write it anew with numpy.savez");
  }

  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (zip_int64_t n = 0; n < zip_get_num_entries(zip_.get(), 0); ++n) {
      const char* const name = zip_get_name(zip_.get(), static_cast<zip_uint64_t>(n), 0);
      if (name != nullptr) names.emplace_back(name);
    }
    return names;
  }

  /// Decompresses one array; memory grows with the actual data, not with the announced size.
  std::vector<std::byte> read(const std::string& part) const {
    const Part file(zip_fopen(zip_.get(), part.c_str(), 0), &zip_fclose);
    std::vector<std::byte> bytes;
    zip_int64_t got = file ? 1 : -1;
    while (got > 0) {
      const std::size_t before = bytes.size();
      if (before + kPiece > kMaxBytes) {
        throw FileError(name_, part, "holds more than 2 GiB; thin the cloud out");
      }
      bytes.resize(before + kPiece);
      got = zip_fread(file.get(), bytes.data() + before, kPiece);
      bytes.resize(before + static_cast<std::size_t>(std::max<zip_int64_t>(got, 0)));
    }
    if (got < 0) throw FileError(name_, part, "cannot be unpacked; write it anew with numpy.savez");
    return bytes;
  }

 private:
  const std::string& name_;
  std::unique_ptr<zip_t, decltype(&zip_discard)> zip_;
};

/// Chooses the array that holds the cloud.
std::string choose(std::vector<std::string> names, const std::string& name) {
  constexpr const char* kPoints = "points.npy";
  if (std::find(names.begin(), names.end(), kPoints) != names.end()) return kPoints;
  std::erase(names, kViewpoint);
  if (names.size() == 1) return names.front();
  const std::string held = names.size() > 20
                               ? fmt::format("{} arrays", names.size())
                               : printable(fmt::format("{}", fmt::join(names, ", ")), 200);
  throw FileError(
      name, "",
      fmt::format("has {}; call the cloud's array 'points'", names.empty() ? "no array" : held));
}

}  // namespace

bool is_npz(std::span<const std::byte> bytes) {
  constexpr std::string_view kMagic = "PK\x03\x04";
  return bytes.size() > kMagic.size() &&
         std::string_view(reinterpret_cast<const char*>(bytes.data()), kMagic.size()) == kMagic;
}

PointCloud parse_npz(std::span<const std::byte> bytes, const std::string& name,
                     const Eigen::Affine3d& X_CF) {
  const Archive archive(bytes, name);
  const std::vector<std::string> names = archive.names();
  const std::string chosen = choose(names, name);
  PointCloud cloud =
      parse_npy(archive.read(chosen), fmt::format("{}: {}", name, printable(chosen)), X_CF);
  if (std::find(names.begin(), names.end(), kViewpoint) != names.end()) {
    const std::string viewpoint(kViewpoint);
    cloud.viewpoint =
        X_CF * parse_npy_vector(archive.read(viewpoint), fmt::format("{}: {}", name, viewpoint));
  }
  return cloud;
}

}  // namespace quadrille::io
