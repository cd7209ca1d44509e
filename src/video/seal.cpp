// SPDX-License-Identifier: MIT
#include "video/seal.h"

#include <cerrno>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

#include <fmt/format.h>
#include <sys/mman.h>

#include "base/error.h"
#include "base/hash.h"
#include "base/system/atomic_file.h"
#include "base/system/system_error.h"

namespace polhode {
namespace {

// The end of a sealed file: a hash of all before it, the length of the text before it, a mark.
constexpr std::string_view kMark = "polhode-seal";
constexpr std::size_t kHashDigits = 32;
constexpr std::size_t kLengthDigits = 10;
constexpr std::size_t kFooter = kHashDigits + kLengthDigits + kMark.size();

constexpr std::string_view kMatroskaBegins = "\x1a\x45\xdf\xa3";  // EBML, RFC 8794

// A file in memory, to be read only.
class MappedFile {
 public:
  // a pipe that nobody writes to is not waited for
  explicit MappedFile(const std::filesystem::path& file) {
    const int handle = open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    const off_t end = handle < 0 ? -1 : lseek(handle, 0, SEEK_END);
    if (end > 0) {
      size_ = static_cast<std::size_t>(end);
      bytes_ = mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, handle, 0);
    }
    const int reason = errno;
    if (handle >= 0) close(handle);
    if (end < 0 || bytes_ == MAP_FAILED) {
      throw system_error(reason, "cannot be read").at({file.string(), 0, {}});
    }
  }
  ~MappedFile() {
    if (bytes_ != nullptr) munmap(bytes_, size_);
  }
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  std::string_view text() const { return {static_cast<const char*>(bytes_), size_}; }

 private:
  void* bytes_ = nullptr;
  std::size_t size_ = 0;
};

// the head of an element of so many bytes, which players skip
std::string element_head(bool matroska, std::size_t bytes) {
  const auto byte = [](std::uint64_t value, int shift) {
    return static_cast<char>((value >> shift) & 0xff);
  };
  // sizes of 4 bytes: a Void's own begins with the bit that says so and leaves its head out, a
  // box's holds the head
  const std::uint64_t size = matroska ? (bytes | 0x10000000U) : bytes + 8;
  const std::string four = {byte(size, 24), byte(size, 16), byte(size, 8), byte(size, 0)};
  return matroska ? fmt::format("\xec{}", four) : fmt::format("{}free", four);
}

void append(const std::filesystem::path& file, std::string_view bytes) {
  if (const int reason = failure_to_write(file, From::end, bytes); reason != 0)
    throw environment_error("cannot write the film: {}", std::strerror(reason));
}

}  // namespace

void seal_file(const std::filesystem::path& file, std::string_view text) {
  const bool matroska = MappedFile(file).text().starts_with(kMatroskaBegins);
  append(file, fmt::format("{}{}", element_head(matroska, text.size() + kFooter), text));
  const std::string hash = content_hash(MappedFile(file).text());
  append(file, fmt::format("{}{:0{}d}{}", hash, text.size(), kLengthDigits, kMark));
}

std::optional<std::string> sealed_text(const std::filesystem::path& file) {
  const MappedFile mapped(file);
  const std::string_view all = mapped.text();
  if (all.size() < kFooter || !all.ends_with(kMark)) return std::nullopt;
  const std::string_view body = all.substr(0, all.size() - kFooter);
  const std::string_view footer = all.substr(body.size());
  std::size_t length = 0;
  const char* digits = footer.data() + kHashDigits;
  std::from_chars(digits, digits + kLengthDigits, length);
  if (length > body.size() || footer.substr(0, kHashDigits) != content_hash(body)) {
    return std::nullopt;
  }
  // the length stands behind the hash: the head of the element, which the hash covers, confirms it
  const std::string_view before = body.substr(0, body.size() - length);
  if (!before.ends_with(element_head(true, length + kFooter)) &&
      !before.ends_with(element_head(false, length + kFooter))) {
    return std::nullopt;
  }
  return std::string(body.substr(body.size() - length));
}

}  // namespace polhode
