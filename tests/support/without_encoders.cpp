// SPDX-License-Identifier: MIT
// Loaded before FFmpeg's libraries, makes them as if they had been built without any encoder.
struct AVCodec;

extern "C" const AVCodec* avcodec_find_encoder_by_name(const char*) {
  return nullptr;
}
