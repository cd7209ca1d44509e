// SPDX-License-Identifier: MIT
#include "image/png.h"

#include <cstdio>
#include <memory>
#include <png.h>

#include "base/atomic_file.h"
#include "base/error.h"

namespace polhode {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

}  // namespace

void write_png(const std::filesystem::path& path, const Image& image, bool with_alpha) {
  AtomicFile target(path);
  const auto failed = [&](const std::string& why) {
    return environment_error("cannot write the picture: {}", why).at({path.string(), 0, {}});
  };

  // libpng's simplified interface drops nothing, so opaque pictures lose their alpha here
  const std::vector<std::uint8_t>* pixels = &image.pixels;
  std::vector<std::uint8_t> rgb;
  if (!with_alpha) {
    rgb.reserve(image.pixels.size() / 4 * 3);
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
      rgb.insert(rgb.end(),
                 image.pixels.begin() + static_cast<std::ptrdiff_t>(i),
                 image.pixels.begin() + static_cast<std::ptrdiff_t>(i) + 3);
    }
    pixels = &rgb;
  }

  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = with_alpha ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
  File file(std::fopen(target.part().c_str(), "wb"));
  if (file == nullptr) throw failed("cannot open its temporary file");
  if (png_image_write_to_stdio(&png, file.get(), 0, pixels->data(), 0, nullptr) == 0) {
    throw failed(png.message);
  }
  if (std::fclose(file.release()) != 0) throw failed("the disk is full");
  target.commit();
}

Image read_png(const std::filesystem::path& path) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  const std::string bytes = read_file(path);
  const auto refuse = [&] {
    const Error error = input_error("is no PNG picture: {}", png.message);
    png_image_free(&png);
    return error.at({path.string(), 0, {}});
  };
  if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0) throw refuse();
  png.format = PNG_FORMAT_RGBA;
  Image image(static_cast<int>(png.width), static_cast<int>(png.height));
  if (png_image_finish_read(&png, nullptr, image.pixels.data(), 0, nullptr) == 0) throw refuse();
  return image;
}

}  // namespace polhode
