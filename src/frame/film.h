// SPDX-License-Identifier: MIT
// A film as a function of time: panels, plots and the text drawn over them.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frame/compose.h"
#include "frame/diagram_picture.h"
#include "frame/label_tracks.h"
#include "frame/labels.h"
#include "frame/layout.h"
#include "frame/placed_text.h"
#include "frame/plot.h"
#include "text/typesetter.h"

namespace polhode {

// The notes in a panel at one moment. Plain text.
struct PanelNotes {
  std::string name;                  // heading of the panel
  std::string figures = {};          // one line below it, large
  std::vector<std::string> details;  // below it, small
  std::string stamp = {};            // a warning below them; empty: none
};

// A part of the frame that shows what one composer draws.
struct FilmPanel {
  PixelBox place;                            // pixels of the frame
  std::shared_ptr<const Composer> composer;  // never null; for pictures of the size of `place`
  double end = 0.0;  // s of motion: end of the known motion; the panel freezes there
  // The notes at the time t (s of motion); called from any thread. Empty: no notes.
  std::function<PanelNotes(double t)> notes = {};
  NoteRows rows = {};  // what notes may have
};

// Where everything stands that is laid over a picture; pixels of the frame.
struct PlacedPage {
  std::vector<TextRoom> rooms;    // of all plots, and of text outside them
  std::vector<PlacedText> texts;  // also those in plots
  std::vector<TextRoom> marks;    // what labels must not cover: heads of arrows, marked points
};

// What stands beside the panels: diagrams, and below them plots over time. Where panels follow one
// another, each diagram is one for each of them, else it is one.
struct FilmCharts {
  std::vector<std::vector<Diagram>> diagrams;
  std::vector<FilmPlot> plots;

  int count() const { return static_cast<int>(diagrams.size() + plots.size()); }
};

// Immutable. Pictures are pure functions of time and may be made from any thread.
class Film {
 public:
  // There is at least one panel; the first one gives the colours of the text and the times of
  // captions, clock and plots. Panels stand where frame_areas() (frame/layout.h) of the same text
  // and the same numbers of panels and charts puts them; with `in_turn`, which is the timeline of
  // all of them together, they follow one another at the place of a single panel.
  Film(std::vector<FilmPanel> panels,
       const FilmText& text,
       PictureSize size,
       FilmCharts charts = {},
       std::optional<Timeline> in_turn = {});
  Film(Film&&) noexcept;
  ~Film();

  // The picture at the time `film` (s of film). Throws Error (environment) as Typesetter does, and
  // (check_failed) as Motion::at does. Opens fonts, so call it after any fork.
  Picture at(double film) const;
  // The picture at that time without text, plots and separator lines. Throws Error (check_failed)
  // as Motion::at does.
  Picture bare_at(double film) const;
  // The first time after `film` at which another panel follows or a panel is cut to another camera,
  // s of film; infinite: never.
  double next_cut(double film) const;
  const std::vector<FilmPanel>& panels() const { return panels_; }
  // Where everything stands at this moment; for tests. Throws Error as at() does.
  PlacedPage placed(double film) const;

 private:
  struct Page;
  struct WithFonts;
  const WithFonts& with_fonts() const;
  // A panel that is shown at a time, and its own time, s of film.
  struct Shown {
    std::size_t panel;
    double film;
  };
  std::vector<Shown> shown_at(double film) const;
  // the story's caption at a time, else that of the film
  std::string caption_at(double film) const;
  // how long each panel is shown in turn, s of film
  double turn() const;
  const Timeline& timeline() const;
  // Whether the frame is divided, so that its text stands in bars.
  bool is_divided() const;
  void add_charts(double film, Page& page) const;
  void add_frame_text(double film, Page& page) const;
  void add_bars(double film, Page& page) const;
  // Returns where they end, px of the frame.
  double add_notes(const FilmPanel& panel, double t, Page& page) const;
  // The chevron that points to a body outside the panel, below `top`, and what it means.
  void add_way_to_body(const FilmPanel& panel, const Vec2& way, double top, Page& page) const;
  struct Layout;
  // The labels of a panel at one moment, below `top` and off `text`.
  Layout layout_of(const FilmPanel& panel,
                   const LabelView& view,
                   double top,
                   const std::vector<TextRoom>& text) const;
  LabelTracks tracks_of(std::size_t panel) const;
  void add_labels(const FilmPanel& panel,
                  const LabelTracks& tracks,
                  const LabelView& view,
                  double film,
                  double top,
                  Page& page) const;
  // Returns the rectangle of its ink.
  TextRoom add_text(TextRole role,
                    const std::string& markup,
                    const TextStyle& style,
                    double x,
                    double y,
                    Page& page) const;
  Page page_at(double film) const;

  std::vector<FilmPanel> panels_;
  std::optional<Timeline> in_turn_;
  FilmText text_;
  PictureSize size_;
  FrameAreas areas_;
  std::vector<Stamp> seams_;  // thin lines between panels
  std::unique_ptr<Typesetter> typesetter_;
  std::unique_ptr<WithFonts> with_fonts_;  // what is made once, with the first picture
};

}  // namespace polhode
