// SPDX-License-Identifier: MIT
#include "film/drawing_process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <new>
#include <poll.h>
#include <unistd.h>

#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>

#include "base/check.h"
#include "base/error.h"
#include "base/json.h"
#include "base/system/interrupt.h"

namespace polhode {
namespace {

constexpr int kSlots = 3;    // frames that one process may be ahead
constexpr int kBoxes = 256;  // a picture of more is handed over whole

enum class Kind { info, frame, error };

// From the child; text follows where length says so.
struct Message {
  Kind kind = Kind::frame;
  std::uint32_t length = 0;  // bytes of JSON
  DrawingTimes times;        // so far
};

bool send_all(int channel, const void* bytes, std::size_t count) {
  const char* from = static_cast<const char*>(bytes);
  while (count > 0) {
    const ssize_t sent = send(channel, from, count, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    from += sent;
    count -= static_cast<std::size_t>(sent);
  }
  return true;
}

bool send_message(int channel, Kind kind, const DrawingTimes& times, const Json& json) {
  const std::string text =
      json.is_null() ? "" : json.dump(-1, ' ', false, Json::error_handler_t::replace);
  const Message message{kind, static_cast<std::uint32_t>(text.size()), times};
  return send_all(channel, &message, sizeof message) && send_all(channel, text.data(), text.size());
}

Json error_json(const Error& error) {
  const Place& place = error.place();
  return {static_cast<int>(error.fault()), error.message(), place.file, place.line, place.key};
}

Json info_json(const RendererInfo& info) {
  return {info.backend, info.gl_renderer, info.gl_version, info.samples, info.by_outlines};
}

std::size_t row_bytes(const PixelBox& box) {
  return 4 * static_cast<std::size_t>(box.width);
}

// every file but standard streams and this one: outputs are the parent's, and so are their locks
void close_others(int kept) {
  constexpr unsigned kFirst = STDERR_FILENO + 1;
  const auto own = static_cast<unsigned>(kept);
  if (own > kFirst) close_range(kFirst, own - 1, 0);
  close_range(own + 1, ~0U, 0);
}

}  // namespace

// A picture in shared memory: whole, or the boxes that differ from its ground one after another.
struct DrawingProcess::Slot {
  bool whole = true;
  std::array<std::uint8_t, 4> ground = {};
  int boxes = 0;
  std::array<PixelBox, kBoxes> painted = {};

  std::uint8_t* pixels() { return reinterpret_cast<std::uint8_t*>(this + 1); }

  void put(const Image& image) {
    std::size_t used = 0;
    for (const PixelBox& box : image.painted) {
      used += row_bytes(box) * static_cast<std::size_t>(box.height);
    }
    whole = !image.ground || image.painted.size() > kBoxes || used > image.pixels.size();
    std::uint8_t* to = pixels();
    if (whole) {
      std::copy(image.pixels.begin(), image.pixels.end(), to);
      return;
    }
    ground = *image.ground;
    boxes = 0;
    for (const PixelBox& box : image.painted) {
      painted[static_cast<std::size_t>(boxes++)] = box;
      for (int y = box.y; y < box.bottom(); ++y) {
        to = std::copy_n(image.at(box.x, y), row_bytes(box), to);
      }
    }
  }

  void take(Image& image, const PictureSize& size) {
    const std::uint8_t* from = pixels();
    if (whole) {
      if (image.width != size.width || image.height != size.height) {
        image = Image(size.width, size.height);
      }
      image.ground.reset();
      image.painted.clear();
      std::copy_n(from, image.pixels.size(), image.pixels.begin());
      return;
    }
    image.wipe(size.width, size.height, ground);
    for (int i = 0; i < boxes; ++i) {
      const PixelBox& box = painted[static_cast<std::size_t>(i)];
      for (int y = box.y; y < box.bottom(); ++y) {
        std::copy_n(from, row_bytes(box), image.at(box.x, y));
        from += row_bytes(box);
      }
      image.painted.push_back(box);
    }
  }
};

std::size_t DrawingProcess::slot_bytes() const {
  const std::size_t bytes = sizeof(Slot) + 4 * static_cast<std::size_t>(size_.width) *
                                               static_cast<std::size_t>(size_.height);
  constexpr std::size_t kPage = 4096;
  return (bytes + kPage - 1) / kPage * kPage;
}

DrawingProcess::Slot& DrawingProcess::slot(int index) const {
  auto* bytes = static_cast<char*>(memory_) + static_cast<std::size_t>(index) * slot_bytes();
  return *std::launder(reinterpret_cast<Slot*>(bytes));
}

DrawingProcess::DrawingProcess(PictureSize size,
                               const std::vector<int>& frames,
                               const std::function<std::unique_ptr<FrameRenderer>()>& open)
    : size_(size) {
  memory_ = mmap(
      nullptr, kSlots * slot_bytes(), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory_ == MAP_FAILED) throw environment_error("not enough memory for so many --jobs");
  for (int i = 0; i < kSlots; ++i) {
    new (static_cast<char*>(memory_) + static_cast<std::size_t>(i) * slot_bytes()) Slot;
  }
  std::array<int, 2> ends = {-1, -1};
  const bool connected = socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) == 0;
  const pid_t parent = getpid();
  process_ = connected ? fork() : -1;
  if (process_ < 0) {
    const int reason = errno;
    for (const int end : ends) {
      if (end >= 0) close(end);
    }
    munmap(memory_, kSlots * slot_bytes());
    throw environment_error("cannot start a drawing process: {}", std::strerror(reason));
  }
  if (process_ > 0) {
    close(ends[1]);
    channel_ = ends[0];
    return;
  }
  // the child: never outlives its parent, leaves signals to it
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(0);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    std::signal(signal, SIG_IGN);
  }
  channel_ = ends[1];
  close_others(channel_);
  draw(frames, open);
}

DrawingProcess::~DrawingProcess() {
  if (process_ > 0) {
    kill(process_, SIGKILL);
    while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  if (channel_ >= 0) close(channel_);
  munmap(memory_, kSlots * slot_bytes());
}

// the child's life; nothing of the parent is unwound
void DrawingProcess::draw(const std::vector<int>& frames,
                          const std::function<std::unique_ptr<FrameRenderer>()>& open) {
  try {
    // the rasteriser draws on this thread
    setenv("LP_NUM_THREADS", "0", 1);
    const std::unique_ptr<FrameRenderer> renderer = open();
    if (!send_message(channel_, Kind::info, {}, info_json(renderer->info()))) _exit(0);
    Image image;
    int free = kSlots, next = 0;
    for (const int frame : frames) {
      renderer->render(frame, image);
      if (!wait_for_slot(free)) _exit(0);
      slot(next).put(image);
      next = (next + 1) % kSlots;
      if (!send_message(channel_, Kind::frame, renderer->times(), {})) _exit(0);
    }
    // what is shared stays until the parent has taken it
    _exit(0);
  } catch (const Error& error) {
    send_message(channel_, Kind::error, {}, error_json(error));
  } catch (const std::bad_alloc&) {
    send_message(channel_, Kind::error, {}, error_json(environment_error("out of memory")));
  } catch (const std::exception& error) {
    send_message(
        channel_, Kind::error, {}, error_json(environment_error("unexpected: {}", error.what())));
  }
  _exit(0);
}

// a byte comes for each slot that the parent has read; false: it has gone
bool DrawingProcess::wait_for_slot(int& free) const {
  while (free == 0) {
    std::array<char, kSlots> given;
    const ssize_t got = recv(channel_, given.data(), given.size(), 0);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    free += static_cast<int>(got);
  }
  --free;
  return true;
}

void DrawingProcess::read_all(void* bytes, std::size_t count) {
  constexpr int kPatience_ms = 100;  // between looks at our own signals
  char* to = static_cast<char*>(bytes);
  while (count > 0) {
    stop_if_interrupted();
    pollfd file{channel_, POLLIN, 0};
    if (poll(&file, 1, kPatience_ms) <= 0) continue;
    const ssize_t got = recv(channel_, to, count, 0);
    if (got < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (got <= 0) tell_end();
    to += got;
    count -= static_cast<std::size_t>(got);
  }
}

// the child has gone without a word
void DrawingProcess::tell_end() {
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  if (!WIFSIGNALED(status)) {
    throw environment_error("a drawing process ended early, with exit code {}",
                            WEXITSTATUS(status));
  }
  throw environment_error(
      "a drawing process was ended by signal {} ({}); if memory was short, use fewer --jobs",
      WTERMSIG(status),
      strsignal(WTERMSIG(status)));
}

std::string DrawingProcess::read_text(std::size_t length) {
  std::string text(length, '\0');
  read_all(text.data(), length);
  return text;
}

void DrawingProcess::read_message(bool& is_frame) {
  Message message;
  read_all(&message, sizeof message);
  is_frame = message.kind == Kind::frame;
  if (is_frame) {
    times_ = message.times;
    return;
  }
  const Json json = Json::parse(read_text(message.length));
  if (message.kind == Kind::error) {
    throw Error(json.at(0).get<Fault>(), json.at(1), Place{json.at(2), json.at(3), json.at(4)});
  }
  info_ = {json.at(0), json.at(1), json.at(2), json.at(3), json.at(4)};
  known_ = true;
}

const RendererInfo& DrawingProcess::info() {
  bool is_frame = false;
  if (!known_) read_message(is_frame);
  CHECK(known_);
  return info_;
}

void DrawingProcess::next(Image& image) {
  info();
  bool is_frame = false;
  read_message(is_frame);
  CHECK(is_frame);
  slot(taken_ % kSlots).take(image, size_);
  ++taken_;
  // one that has drawn its last frame hears no more
  const char given = 0;
  static_cast<void>(send_all(channel_, &given, 1));
}

}  // namespace polhode
