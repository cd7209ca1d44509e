// SPDX-License-Identifier: MIT
// A film as a function of time: panels, plots and the text drawn over them.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "frame/compose.h"
#include "frame/labels.h"
#include "text/typesetter.h"

namespace polhode {

// The notes in a panel of a comparison, at one moment. Plain text.
struct PanelNotes {
  std::vector<std::string> lines;  // at the top of the panel
  std::string stamp;               // a warning below them; empty: none
};

// A part of the frame that shows what one composer draws.
struct FilmPanel {
  PixelBox place;                            // pixels of the frame
  std::shared_ptr<const Composer> composer;  // never null; for pictures of the size of `place`
  double end = 0.0;  // s of motion: end of the known motion; the panel freezes there
  // The notes at the time t (s of motion); called from any thread. Empty: no notes.
  std::function<PanelNotes(double t)> notes = {};
};

// A plot that is drawn once and revealed from left to right as time passes.
struct FilmPlot {
  PixelBox place;           // pixels of the frame
  SpritePtr axes, curves;   // of the size of `place`; `curves` is revealed
  int first = 0, last = 0;  // columns of `place` (from 0) where the time axis begins and ends
  double begins = 0.0, ends = 0.0;  // the times there, s of motion
};

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

// The rectangles (pixels) of `count` (at least 1) panels that cover the frame in rows of equal
// height. There are as many columns as make the panels nearest to square with few gaps; the panels
// of an incomplete last row are wider.
std::vector<PixelBox> panel_places(PictureSize size, int count);

// The margins that text needs in one panel of a frame of that size, for the automatic camera.
// note_lines: number of lines of PanelNotes.
FrameMargins text_margins(const FilmText& text,
                          const PixelBox& panel,
                          PictureSize size,
                          int note_lines);

// Immutable. Pictures are pure functions of time and may be made from any thread.
class Film {
 public:
  // There is at least one panel; the first one gives the colours of the text and the times of
  // captions, clock and plots.
  Film(std::vector<FilmPanel> panels,
       const FilmText& text,
       PictureSize size,
       std::vector<FilmPlot> plots = {});

  // The picture at the time `film` (s of film). Throws Error (environment) as Typesetter does, and
  // (check_failed) as Motion::at does. Opens fonts, so call it after any fork.
  Picture at(double film) const;
  // The picture at that time without text, plots and separator lines. Throws Error (check_failed)
  // as Motion::at does.
  Picture bare_at(double film) const;
  const std::vector<FilmPanel>& panels() const { return panels_; }
  // The rectangles (pixels of the frame) of all plots and text at this moment, labels last; for
  // tests. Throws Error as at() does.
  std::vector<TextRoom> text_rooms(double film) const;

 private:
  struct Page;
  void add_plots(double t, Page& page) const;
  void add_frame_text(double film, Page& page) const;
  void add_notes(const FilmPanel& panel, double t, Page& page) const;
  void add_labels(const FilmPanel& panel, const std::vector<SeenLabel>& labels, Page& page) const;
  Page page_at(double film) const;

  std::vector<FilmPanel> panels_;
  FilmText text_;
  PictureSize size_;
  std::vector<FilmPlot> plots_;
  std::vector<Stamp> seams_;  // thin lines between panels
  std::unique_ptr<Typesetter> typesetter_;
};

}  // namespace polhode
