// SPDX-License-Identifier: MIT
#include "image/png.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <png.h>
#include <string_view>
#include <vector>

#include "base/check.h"
#include "base/error.h"
#include "base/system/atomic_file.h"

namespace polhode {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

// libpng's reader keeps memory until it is told that a picture is done with
struct Reader : png_image {
  Reader() : png_image{} { version = PNG_IMAGE_VERSION; }
  ~Reader() { png_image_free(this); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
};

// libpng's simplified interface drops nothing, so opaque pictures lose their alpha here
std::vector<std::uint8_t> without_alpha(const Image& image) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(image.pixels.size() / 4 * 3);
  for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
    rgb.insert(rgb.end(), {image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]});
  }
  return rgb;
}

png_image header_of(const Image& image, bool with_alpha) {
  CHECK(image.width > 0 && image.height > 0);
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = with_alpha ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
  return png;
}

struct Chunk {
  std::string_view type, whole;
};

// The chunks of a PNG file, up to its last: a length, a type, so many bytes and a checksum.
std::vector<Chunk> chunks_of(std::string_view bytes) {
  constexpr std::size_t kSignature = 8, kAround = 12;
  const auto byte = [&](std::size_t i) {
    return static_cast<unsigned char>(bytes[i]);
  };
  std::vector<Chunk> chunks;
  for (std::size_t i = kSignature; i + kAround <= bytes.size();) {
    const std::size_t length =
        kAround + (std::size_t{byte(i)} << 24U | std::size_t{byte(i + 1)} << 16U |
                   std::size_t{byte(i + 2)} << 8U | std::size_t{byte(i + 3)});
    chunks.push_back({bytes.substr(i + 4, 4), bytes.substr(i, length)});
    if (chunks.back().type == "IEND") break;
    i += length;
  }
  return chunks;
}

bool has_chunk(const std::string& bytes, std::string_view type) {
  const std::vector<Chunk> chunks = chunks_of(bytes);
  return std::any_of(
      chunks.begin(), chunks.end(), [&](const Chunk& chunk) { return chunk.type == type; });
}

}  // namespace

void write_png(const std::filesystem::path& path, const Image& image, bool with_alpha) {
  AtomicFile file(path);
  write_png(file, image, with_alpha);
  file.commit();
}

void write_png(const AtomicFile& target, const Image& image, bool with_alpha) {
  // the system's reason, where there is one, says more than libpng's
  const auto failed = [&](const char* why) {
    return environment_error("cannot write the picture: {}",
                             errno != 0 ? std::strerror(errno) : why)
        .at({target.target().string(), 0, {}});
  };

  png_image png = header_of(image, with_alpha);
  const std::vector<std::uint8_t> rgb =
      with_alpha ? std::vector<std::uint8_t>() : without_alpha(image);
  const std::uint8_t* pixels = with_alpha ? image.pixels.data() : rgb.data();

  errno = 0;
  File file(open_existing(target.part(), From::start));
  if (file == nullptr) throw failed("cannot open its temporary file");
  if (png_image_write_to_stdio(&png, file.get(), 0, pixels, 0, nullptr) == 0) {
    throw failed(png.message);
  }
  // what is still buffered is written now: a full disk often shows here only
  if (std::fclose(file.release()) != 0) throw failed("cannot close its temporary file");
}

std::string encode_png(const Image& image, bool with_alpha) {
  png_image png = header_of(image, with_alpha);
  const std::vector<std::uint8_t> rgb =
      with_alpha ? std::vector<std::uint8_t>() : without_alpha(image);
  const std::uint8_t* pixels = with_alpha ? image.pixels.data() : rgb.data();

  // a bound on the size, cut to what was needed
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&png, bytes.data(), &size, 0, pixels, 0, nullptr) == 0) {
    throw environment_error("cannot encode a picture: {}", png.message);
  }
  bytes.resize(size);
  return bytes;
}

bool is_animation(const std::string& bytes) {
  return has_chunk(bytes, "acTL");
}

Image read_png(const std::filesystem::path& path) {
  const std::string bytes = read_file(path, 5 * kMostPngPixels);
  if (is_animation(bytes)) {
    throw input_error("is an animation, of which a picture is only the first; name it .apng")
        .at({path.string(), 0, {}});
  }
  return decode_png(bytes, path.string());
}

std::string png_tags(const std::filesystem::path& path) {
  const std::string bytes = read_file(path, 5 * kMostPngPixels);
  std::string tags;
  for (const Chunk& chunk : chunks_of(bytes)) {
    // pixels, and the frames of an animation, of which their number counts
    const bool of_pixels = chunk.type == "IDAT" || chunk.type == "fdAT";
    constexpr std::size_t kHead = 8, kNumber = 4;  // bytes: length and type; of a number
    if (chunk.type == "acTL") {
      tags += chunk.whole.substr(0, kHead + kNumber);
    } else if (!of_pixels && chunk.type != "fcTL") {
      tags += chunk.whole;
    }
  }
  return tags;
}

Image decode_png(const std::string& bytes, const std::string& name) {
  const Place place{name, 0, {}};
  // libpng shows what there is of a picture that was cut off behind its pixels, and says what is
  // wrong with other files
  if (bytes.starts_with("\x89PNG") && !has_chunk(bytes, "IEND"))
    throw input_error("is not a whole PNG picture: it ends before its last chunk").at(place);
  // depth and order of rows are in the first chunk
  constexpr std::size_t kDepth = 24, kInterlaced = 28;
  if (bytes.size() > kInterlaced && bytes[kDepth] == 16 && bytes[kInterlaced] != 0) {
    // libpng 1.6 mixes the rows of its passes up
    throw input_error("is an interlaced picture of 16 bits a channel; save it without interlacing")
        .at(place);
  }
  Reader png;
  const auto refuse = [&] {
    return input_error("is not a PNG picture: {}", png.message).at(place);
  };
  if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0) throw refuse();

  png.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;  // 16 bits without a gamma are no linear light
  // a size is only a claim until the pixels have been seen: believe no more than memory may hold
  if (std::size_t{png.width} * png.height > kMostPngPixels) {
    throw input_error("claims {}x{} pixels, too many to read", png.width, png.height).at(place);
  }
  png.format = PNG_FORMAT_RGBA;
  Image image(static_cast<int>(png.width), static_cast<int>(png.height));
  if (png_image_finish_read(&png, nullptr, image.pixels.data(), 0, nullptr) == 0) throw refuse();
  return image;
}

}  // namespace polhode
