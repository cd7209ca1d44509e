// SPDX-License-Identifier: MIT
// Writes PNG pictures: a single one, or a numbered sequence.
#pragma once

#include "video/frame_sink.h"

namespace polhode {

// A sink for a single picture. Throws Error (input), with the output as place, unless job.still,
// and as AtomicFile (base/system/atomic_file.h) does. Its members throw Error (environment) if
// writing fails.
std::unique_ptr<FrameSink> make_png_sink(const SinkJob& job);
// A sink for a sequence such as NAME_%05d.png: one %d, or %0Nd with N from 1 to 9. The numbers
// begin with FilmMetadata::first, 0 by default. Only the lock of the first frame is kept: it guards
// the sequence against another run. The files get their names in finish(), so a failure before that
// leaves older frames unchanged; if finish() itself fails, the destructor removes the frames that
// were already named. Throws Error (input) as AtomicFile, for frame 0, and parse_numbered_name do.
// push() throws Error as AtomicFile does, for each frame; push() and finish() throw Error
// (environment) if writing fails.
std::unique_ptr<FrameSink> make_png_sequence_sink(const SinkJob& job);

// A parsed file-name pattern.
struct NumberedName {
  std::string before;  // the text before the number
  std::string after;   // the text after it
  int width = 0;       // least number of digits, padded with zeros; 0: no padding

  // The file name with that number.
  std::string of(int index) const;
};

// Whether the name of the file, without its folders, has a % in it, as those of sequences do.
bool has_percent(const std::string& output);

// Whether that name contains a %d or %0Nd (N from 1 to 9).
bool has_frame_number(const std::string& pattern);

// Parses a pattern. Throws Error (input), with the pattern as place, unless the name of the file
// has exactly one %d or %0Nd (N from 1 to 9) and no other %.
NumberedName parse_numbered_name(const std::string& pattern);

}  // namespace polhode
