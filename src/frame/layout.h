// SPDX-License-Identifier: MIT
// Where the parts of a frame stand: panels, plots, title and caption; and how large text is.
#pragma once

#include <string>
#include <vector>

#include "frame/camera.h"
#include "frame/view_spec.h"
#include "image/picture_size.h"
#include "image/pixel_box.h"

namespace polhode {

// The text of the whole frame. Title and captions are plain text, not markup.
struct FilmText {
  std::string title;        // empty: none
  std::string caption;      // shown while the story has no caption; empty: none
  bool captions = false;    // the story has captions: space is reserved for them
  bool clock = true;        // show the time of the motion
  bool labels = true;       // show the names of vectors
  double time_scale = 1.0;  // seconds of motion per second of film
  double size = 1.0;        // factor by which all text is enlarged
};

// The text that [show] asks for; the caller sets FilmText::captions. time_scale: seconds of motion
// per second of film.
FilmText film_text(const ShowSpec& show, const std::string& title, double time_scale);

// The unit in which a film shows times: seconds, for planets hours or days.
struct TimeUnit {
  double seconds = 1.0;
  std::string name = "s";
};
TimeUnit time_unit(double time_scale);

// The rectangles (pixels) of `count` (at least 1) panels that cover a frame of that size in rows of
// equal height. There are as many columns as make the panels nearest to square with few gaps; the
// panels of an incomplete last row are wider.
std::vector<PixelBox> panel_places(PictureSize size, int count);

// The parts of a frame, pixels; they do not overlap. A frame with one panel and no charts is all
// panel, and its text is laid over it.
struct FrameAreas {
  PixelBox title;    // a bar above for title and clock; empty: none
  PixelBox caption;  // a bar below; empty: none
  PixelBox plots;    // for plots and diagrams; empty: none
  std::vector<PixelBox> panels;
};
FrameAreas frame_areas(const FilmText& text, PictureSize size, int panels, int charts);

// Where diagrams stand, one below the other, and under them a stack of plots; pixels. A diagram is
// as high as two plots. Empty places for what there is none of.
struct ChartPlaces {
  std::vector<PixelBox> diagrams;
  PixelBox plots;
};
ChartPlaces chart_places(const PixelBox& room, int diagrams, int plots);

// What PanelNotes (frame/film.h) of a panel may have.
struct NoteRows {
  bool name = false;
  bool figures = false;
  bool stamp = false;
  int details = 0;  // number of lines
};

// Sizes of type of the notes in a panel, pixels, and the height of all rows.
struct NoteSizes {
  double name = 0.0, figures = 0.0, details = 0.0, stamp = 0.0;
  double height = 0.0;
};
NoteSizes note_sizes(const FilmText& text,
                     const PixelBox& panel,
                     PictureSize size,
                     const NoteRows& rows);
inline constexpr double kLineHeight = 1.3;  // of a row of notes, of its type

// Sizes of type, pixels: of labels in a panel of a frame of that size, and of title, caption, clock
// and plots.
double label_size(const FilmText& text, const PixelBox& panel, PictureSize size);
double title_size(const FilmText& text, PictureSize size);
double caption_size(const FilmText& text, PictureSize size);
double clock_size(const FilmText& text, PictureSize size);
double plot_text_size(const FilmText& text, PictureSize size);
// The smallest size of type that can be read in the last row of a lecture hall.
double least_text_size(const FilmText& text, PictureSize size);
// What is free at the sides of a part of the frame, pixels.
double edge_of(const PixelBox& part);

// The margins that text needs in one panel of a frame of that size, for the automatic camera.
FrameMargins text_margins(const FilmText& text,
                          const PixelBox& panel,
                          PictureSize size,
                          const NoteRows& rows);

}  // namespace polhode
