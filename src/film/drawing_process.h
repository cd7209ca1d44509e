// SPDX-License-Identifier: MIT
// A child process that renders frames; the parent reads them in order through shared memory.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "film/frame_renderer.h"
#include "image/picture_size.h"

namespace polhode {

// The parent's side. Invariant: the process ends with this object or with the parent, whichever
// ends first, and this object reaps it. Not thread-safe.
class DrawingProcess {
 public:
  // Forks; call it before this process has opened fonts or OpenGL. The child, in which only the
  // calling thread lives on, closes the parent's files except the standard streams, ignores SIGINT,
  // SIGTERM and SIGHUP, calls open(), renders the frames with the numbers `frames` in this order,
  // at most three ahead of the parent, and exits. `size` is that of the frames. The arguments are
  // not kept by the parent. Throws Error (environment) if shared memory or process cannot be
  // created.
  DrawingProcess(PictureSize size,
                 const std::vector<int>& frames,
                 const std::function<std::unique_ptr<FrameRenderer>()>& open);
  ~DrawingProcess();
  DrawingProcess(const DrawingProcess&) = delete;
  DrawingProcess& operator=(const DrawingProcess&) = delete;

  // What the child draws with. Waits until the child's renderer is open; valid as long as this
  // object. Throws Error as next() does.
  const RendererInfo& info();
  // Waits for the next of `frames` and copies it into `image`, which is resized if needed. Call it
  // once per frame. Throws the Error that ended the child, Error (environment) if the child ended
  // without one, for example because it was killed, and (interrupted).
  void next(Image& image);
  // The child's drawing times, up to the last frame that next() has read.
  const DrawingTimes& times() const { return times_; }

 private:
  struct Slot;
  Slot& slot(int index) const;
  std::size_t slot_bytes() const;
  [[noreturn]] void draw(const std::vector<int>& frames,
                         const std::function<std::unique_ptr<FrameRenderer>()>& open);
  bool wait_for_slot(int& free) const;
  void read_all(void* bytes, std::size_t count);
  std::string read_text(std::size_t length);
  void read_message(bool& is_frame);
  [[noreturn]] void tell_end();

  PictureSize size_;
  void* memory_ = nullptr;  // shared
  int channel_ = -1;        // socket: messages from the child; to the child, a byte per freed slot
  int process_ = -1;
  int taken_ = 0;       // frames
  bool known_ = false;  // whether info_ has arrived
  RendererInfo info_;
  DrawingTimes times_;
};

}  // namespace polhode
