// SPDX-License-Identifier: MIT
// A film as a function of time: its panels, and the text that is laid over them.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "frame/compose.h"
#include "frame/labels.h"
#include "text/typesetter.h"

namespace polhode {

// Words about a moment, for a panel that is compared with others. Plain text.
struct PanelNotes {
  std::vector<std::string> lines;  // at the top
  std::string stamp;               // under them, in an alarming colour; empty: none
};

struct FilmPanel {
  PixelBox place;
  std::shared_ptr<const Composer> composer;
  double end = 0.0;  // s: the last moment that is known; the picture stands still behind it
  std::function<PanelNotes(double t)> notes = {};
};

// A plot that is drawn once and revealed from left to right.
struct FilmPlot {
  PixelBox place;
  SpritePtr axes, curves;           // as large as the place
  int first = 0, last = 0;          // columns of the place where time begins and ends
  double begins = 0.0, ends = 0.0;  // those times, s of the motion
};

// Text of the whole frame. Plain text.
struct FilmText {
  std::string title;      // empty: none
  std::string caption;    // where the story has none; empty: none
  bool captions = false;  // the story has some: room is kept for them
  bool clock = true;
  bool labels = true;
  double time_scale = 1.0;  // seconds of motion per second of film
  double size = 1.0;        // all text is enlarged by this
};

// The text that a scene's [show] asks for.
FilmText film_text(const ShowSpec& show, const std::string& title, double time_scale);

// Equal panels side by side, or in rows where that leaves them less narrow. Together they cover the
// frame.
std::vector<PixelBox> panel_places(PictureSize size, int count);

// The room that text needs at the sides of one panel: what an automatic camera leaves free.
// note_lines: of PanelNotes.
FrameMargins text_margins(const FilmText& text,
                          const PixelBox& panel,
                          PictureSize size,
                          int note_lines);

// Immutable; at() is a pure function of t and may be called from any thread.
class Film {
 public:
  Film(std::vector<FilmPanel> panels,
       const FilmText& text,
       PictureSize size,
       std::vector<FilmPlot> plots = {});

  // At a moment of the film, s.
  Picture at(double film) const;
  // The same panels with nothing laid over them: no text, plots or lines between panels.
  Picture bare_at(double film) const;
  const std::vector<FilmPanel>& panels() const { return panels_; }
  // Where text stands at this moment, labels last; for tests.
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
