// SPDX-License-Identifier: MIT
// One process that draws frames for another, which reads them in order.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "film/frame_renderer.h"
#include "image/picture_size.h"

namespace polhode {

// The parent's side. Invariant: the process ends with this object or with the parent, whichever is
// first, and is reaped by this object.
class DrawingProcess {
 public:
  // Forks; the child calls open(), draws all of `frames` in their order and ends. Throws Error
  // (environment) without memory or processes.
  DrawingProcess(PictureSize size,
                 const std::vector<int>& frames,
                 const std::function<std::unique_ptr<FrameRenderer>()>& open);
  ~DrawingProcess();
  DrawingProcess(const DrawingProcess&) = delete;
  DrawingProcess& operator=(const DrawingProcess&) = delete;

  // What draws there; waits until it is known. Throws Error as next() does.
  const RendererInfo& info();
  // The next of its frames. Throws what the child could not do, Error (environment) when it has
  // been killed, (interrupted) when a signal asks us to stop.
  void next(Image& image);
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
  int channel_ = -1;        // a socket: messages from the child, a byte for each slot given back
  int process_ = -1;
  int taken_ = 0;       // frames
  bool known_ = false;  // is info_?
  RendererInfo info_;
  DrawingTimes times_;
};

}  // namespace polhode
