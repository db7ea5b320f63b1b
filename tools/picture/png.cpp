#include "picture/png.hpp"

#include <png.h>

#include "io/file_bytes.hpp"
#include "io/new_file.hpp"

namespace quadrille {

void write_png(const std::string& path, const Image& image) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width());
  header.height = static_cast<png_uint_32>(image.height());
  header.format = PNG_FORMAT_RGB;
  const std::vector<std::uint8_t> bytes = image.bytes();
  io::NewFile file(path);
  if (png_image_write_to_file(&header, file.path().c_str(), 0, bytes.data(), 0, nullptr) == 0) {
    throw io::FileError(path, "",
                        std::string("cannot be written (") + header.message +
                            "); check the folder and the space left");
  }
  file.commit();
}

}  // namespace quadrille
