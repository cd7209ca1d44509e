// SPDX-License-Identifier: MIT
#include "video/libav/film_output.h"

#include <algorithm>
#include <cerrno>
#include <climits>
#include <poll.h>
#include <unistd.h>

#include "base/system/interrupt.h"
#include "video/frame_sink.h"
#include "video/libav/libav.h"
#include "video/seal.h"

namespace polhode {
namespace {

constexpr int kBuffer = 1 << 16;  // bytes

bool interrupted() {
  try {
    stop_if_interrupted();
  } catch (const Error&) {
    return true;
  }
  return false;
}

// Waits for room before each piece: a pipe that has room takes PIPE_BUF bytes without blocking, so
// that the flag of a signal is seen even if nobody reads any more. Byte: FFmpeg 7 has made it
// const.
template <class Byte>
int write_to_standard_output(void*, Byte* bytes, int count) {
  constexpr int kPatienceMs = 100;
  for (int done = 0; done < count;) {
    if (interrupted()) return AVERROR_EXIT;
    pollfd room{STDOUT_FILENO, POLLOUT, 0};
    const int ready = poll(&room, 1, kPatienceMs);
    if (ready == 0 || (ready < 0 && errno == EINTR)) continue;
    const auto piece = static_cast<std::size_t>(std::min(count - done, PIPE_BUF));
    const ssize_t written = write(STDOUT_FILENO, bytes + done, piece);
    if (written < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (written < 0) return AVERROR(errno);
    done += static_cast<int>(written);
  }
  return count;
}

AVIOContext* open_standard_output() {
  if (isatty(STDOUT_FILENO) != 0) {
    throw input_error(
        "a film cannot be written to a terminal; send it to a program or a file, as in "
        "-o - | ffplay -");
  }
  auto* buffer = static_cast<std::uint8_t*>(made(av_malloc(kBuffer)));
  AVIOContext* stream =
      avio_alloc_context(buffer, kBuffer, 1, nullptr, nullptr, write_to_standard_output, nullptr);
  if (stream == nullptr) av_free(buffer);
  return made(stream);
}

}  // namespace

FilmOutput::FilmOutput(const std::string& output) {
  if (output == kStandardOutput) {
    stream_ = open_standard_output();
    return;
  }
  file_.emplace(output);
  // the protocol is named, or libav would find one in a name such as "take:1.mp4"
  url_ = "file:" + file_->part().string();
  check_libav(avio_open(&stream_, url_.c_str(), AVIO_FLAG_WRITE),
              fmt::format("cannot open the film {}", output));
}

FilmOutput::~FilmOutput() {
  if (stream_ == nullptr) return;
  if (file_) {
    avio_closep(&stream_);
  } else {
    av_freep(&stream_->buffer);
    avio_context_free(&stream_);
  }
}

void FilmOutput::finish(const std::optional<std::string>& seal) {
  avio_flush(stream_);
  check_libav(stream_->error, "cannot write the film");
  if (!file_) return;
  check_libav(avio_closep(&stream_), "cannot close the film");
  if (seal) seal_file(file_->part(), *seal);
  file_->commit();
}

}  // namespace polhode
