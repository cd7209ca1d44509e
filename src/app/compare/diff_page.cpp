// SPDX-License-Identifier: MIT
#include "app/compare/diff_page.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "base/base64.h"
#include "base/version.h"
#include "html/escape.h"
#include "html/page_parts.h"
#include "image/png.h"

namespace polhode {
namespace {

constexpr int kSmallWidth = 640;  // pixels: below this a picture is shown with hard pixels
constexpr int kColumns = 600;     // of a strip at most

std::string img(const Image& image, const char* of, const std::string& alt) {
  return fmt::format(
      "<img class=\"{}\" width=\"{}\" height=\"{}\" alt=\"{}\" src=\"data:image/png;base64,{}\">",
      of,
      image.width,
      image.height,
      alt,
      base64(encode_png(image, !is_opaque(image))));
}

std::string figure(const Image& image, const char* of, const std::string& caption) {
  return fmt::format(
      "<figure>{}<figcaption>{}</figcaption></figure>\n", img(image, of, caption), caption);
}

// the four pictures of a frame, or of a part of it
std::string figures(const Image& reference,
                    const Image& actual,
                    const Image& difference,
                    const Image& heat,
                    const char* classes) {
  std::string text = fmt::format("<div class=\"four {}\">\n", classes);
  text += figure(reference, "reference", "Reference");
  text += figure(actual, "actual", "Actual");
  text += figure(difference, "difference", fmt::format("Difference × {}", kDifferenceGain));
  text += fmt::format(
      "<figure>{}<figcaption>FLIP</figcaption>"
      "<div class=\"scale\">0 <i></i> 1</div></figure>\n",
      img(heat, "heat", "FLIP"));
  return text + "</div>\n";
}

std::string viewer(const ShownFrame& shown) {
  std::string text = fmt::format("<div class=\"viewer{}\">\n<div class=\"modes\">",
                                 shown.reference.width < kSmallWidth ? " small" : "");
  for (const auto& [mode, name] : {std::pair{"slide", "Slide"},
                                   {"flip", "Flip"},
                                   {"difference", "Difference"},
                                   {"heat", "FLIP map"}})
    text += fmt::format("<button type=\"button\" data-mode=\"{}\">{}</button>", mode, name);
  text += "</div>\n<div class=\"stage\" data-mode=\"slide\">";
  text += fmt::format("<img data-of=\"reference\" width=\"{}\" height=\"{}\" alt=\"Reference\">",
                      shown.reference.width,
                      shown.reference.height);
  for (const auto& [of, name] :
       {std::pair{"actual", "Actual"}, {"difference", "Difference"}, {"heat", "FLIP map"}})
    text += fmt::format("<img class=\"top {0}\" data-of=\"{0}\" alt=\"{1}\">", of, name);
  text +=
      "<div class=\"bar\"></div><input type=\"range\" min=\"0\" max=\"100\" step=\"0.1\" "
      "value=\"50\" aria-label=\"how much of the reference is shown, percent\"></div>\n"
      "<p class=\"hint\"></p></div>\n";
  return text;
}

// `over`: more than is allowed
std::string row(const char* name, const std::string& value, const std::string& allowed, bool over) {
  return fmt::format("<tr><th>{}</th><td{}>{}</td><td class=\"soft\">{}</td></tr>\n",
                     name,
                     over ? " class=\"bad\"" : "",
                     value,
                     allowed);
}

// the numbers of a frame or of a film, and what is allowed
std::string numbers(const Difference& d,
                    const std::optional<double>& ssim,
                    const std::optional<double>& flip,
                    const Thresholds& t) {
  const double ratio = psnr(d.rms);
  std::string text = "<div class=\"scroll\"><table>\n";
  text += row("Largest difference",
              fmt::format("{} levels of 255", d.largest),
              fmt::format("limit {}", largest_allowed(t)),
              d.largest > largest_allowed(t));
  text += row("Pixels over the threshold",
              percent(d.fraction_over),
              fmt::format("allowed {} over {} levels", percent(t.fraction), t.max),
              d.fraction_over > t.fraction);
  text += row("Mean absolute difference", fmt::format("{:.4g} levels", d.mean), "", false);
  text += row("RMSE", fmt::format("{:.4g} levels", d.rms), "", false);
  text +=
      row("PSNR", std::isfinite(ratio) ? fmt::format("{:.2f} dB", ratio) : "infinite", "", false);
  if (ssim) {
    text += row("SSIM",
                fmt::format("{:.6f}", *ssim),
                t.ssim ? fmt::format("least {}", *t.ssim) : "",
                t.ssim && *ssim < *t.ssim);
  }
  if (flip) {
    text += row("Mean FLIP",
                fmt::format("{:.6f}", *flip),
                t.flip ? fmt::format("most {}", *t.flip) : "",
                t.flip && *flip > *t.flip);
  }
  return text + "</table></div>\n";
}

// a small part of the picture, with its pixels large enough to be counted
std::string worst_part(const ShownFrame& shown, const Image& difference, const Image& heat) {
  const Image& image = shown.reference;
  const PixelBox region = worst_region(
      image, shown.actual, std::max(32, image.width / 20), std::max(18, image.height / 20));
  return fmt::format("<h3>Worst region: {}×{} pixels at {}, {}</h3>\n",
                     region.width,
                     region.height,
                     region.x,
                     region.y) +
         figures(cut_out(image, region),
                 cut_out(shown.actual, region),
                 cut_out(difference, region),
                 cut_out(heat, region),
                 "zoom");
}

std::string frame_part(const ShownFrame& shown, const Thresholds& thresholds) {
  const Image difference = difference_picture(shown.reference, shown.actual, kDifferenceGain);
  const Image heat = heat_picture(shown.flip);
  const FrameScore& score = shown.score;
  std::string text = viewer(shown);
  text += "<h3>Side by side</h3>\n";
  text += figures(shown.reference,
                  shown.actual,
                  difference,
                  heat,
                  shown.reference.width < kSmallWidth ? "figures small" : "figures");
  text += "<h3>Numbers</h3>\n" + numbers(score.values, score.ssim, score.flip, thresholds);
  if (score.values.largest > 0) text += worst_part(shown, difference, heat);
  return text;
}

// One number of every frame as columns, red where the frame is different. Several frames share a
// column where there are many; the largest shows.
std::string strip(const std::string& title,
                  const std::vector<FrameScore>& scores,
                  double top,
                  double rule,
                  double (*value)(const FrameScore&)) {
  const auto count = static_cast<int>(scores.size());
  const int columns = std::min(count, kColumns);
  std::string fine, over;
  for (int c = 0; c < columns; ++c) {
    double highest = 0.0;
    bool different = false;
    for (int i = c * count / columns; i < (c + 1) * count / columns; ++i) {
      const FrameScore& score = scores[static_cast<std::size_t>(i)];
      highest = std::max(highest, value(score));
      different = different || !score.reason.empty();
    }
    if (highest <= 0.0) continue;
    const double height = std::max(1.0, 100.0 * std::min(1.0, highest / top));
    (different ? over : fine) += fmt::format("M{} 100v-{:.4g}h1v{:.4g}z", c, height, height);
  }
  std::string text = fmt::format(
      "<p class=\"strip-title\">{}</p>\n<div class=\"strip\"><svg viewBox=\"0 0 {} 100\" "
      "preserveAspectRatio=\"none\" role=\"img\" aria-label=\"{}\">",
      title,
      columns,
      title);
  text += fmt::format("<path class=\"fine\" d=\"{}\"/><path class=\"over\" d=\"{}\"/>", fine, over);
  const double y = 100.0 - 100.0 * std::min(1.0, rule / top);
  text += fmt::format(
      "<line class=\"rule\" x1=\"0\" x2=\"{}\" y1=\"{:.4g}\" y2=\"{:.4g}\"/>", columns, y, y);
  return text + "</svg>";
}

std::string strips(const DiffPage& page) {
  const Thresholds& t = page.thresholds;
  const FrameScore& last = page.scores.back();
  const std::string ends =
      page.film ? fmt::format("<span>0 s</span><span>{:.4g} s</span>", last.time)
                : fmt::format("<span>first</span><span>last of {}</span>", page.scores.size());
  const std::string end = fmt::format("<div class=\"ends\">{}</div></div>\n", ends);
  double most = 2.0 * t.fraction;
  for (const FrameScore& score : page.scores)
    most = std::max(most, score.values.fraction_over);
  most = std::max(most, 1e-9);
  return "<section><h2>From frame to frame</h2>\n" +
         strip(fmt::format("Largest difference, 0 to 255 levels; dashed: limit {}",
                           largest_allowed(t)),
               page.scores,
               255.0,
               largest_allowed(t),
               [](const FrameScore& s) { return static_cast<double>(s.values.largest); }) +
         end +
         strip(fmt::format("Pixels that differ by more than {} levels, 0 to {}; dashed: allowed {}",
                           t.max,
                           percent(most),
                           percent(t.fraction)),
               page.scores,
               most,
               t.fraction,
               [](const FrameScore& s) { return s.values.fraction_over; }) +
         end +
         fmt::format("<p class=\"soft\">{} of {} frames are different (red).</p>\n",
                     page.summary.different,
                     page.scores.size()) +
         numbers(page.summary.values, page.summary.ssim, page.summary.flip, t) +
         "<p class=\"soft\">Largest of all frames, share and mean over all frames, RMSE of all "
         "values.</p></section>\n";
}

std::string whole_page(const std::string& title, const std::string& body) {
  return fmt::format(
             "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
             "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
             "<title>{}</title>\n<style>\n",
             title) +
         report_css() + "</style>\n</head>\n<body>\n" + body +
         fmt::format("<footer>polhode {}</footer>\n<script>\n", escaped(program_version())) +
         report_js() + "</script>\n</body>\n</html>\n";
}

std::string verdict_line(bool good, const std::string& words) {
  return fmt::format("<p class=\"verdict {}\">{}</p>\n", good ? "good" : "bad", words);
}

}  // namespace

std::string diff_page(const DiffPage& page) {
  const std::string actual = escaped(page.actual), reference = escaped(page.reference);
  std::string body = fmt::format("<h1>{} against {}</h1>\n", actual, reference);
  body += verdict_line(page.same, page.same ? "Same" : "Different: " + escaped(page.reason));
  if (page.scores.size() > 1) body += strips(page);
  for (const ShownFrame& shown : page.shown) {
    const std::string title = shown.title.empty() ? "" : "Worst: " + shown.title;
    body += "<section>\n";
    if (!title.empty()) {
      body += fmt::format("<h2>{}</h2>\n", escaped(title));
      body += verdict_line(shown.score.reason.empty(),
                           shown.score.reason.empty() ? "Same" : escaped(shown.score.reason));
    }
    body += frame_part(shown, page.thresholds) + "</section>\n";
  }
  return whole_page(
      fmt::format("{}: {} against {}", page.same ? "Same" : "Different", actual, reference), body);
}

std::string golden_page(const std::string& title, const std::vector<GoldenSection>& sections) {
  const auto bad = std::count_if(
      sections.begin(), sections.end(), [](const GoldenSection& one) { return !one.good; });
  std::string body = fmt::format("<h1>{}</h1>\n", escaped(title));
  body += verdict_line(bad == 0,
                       bad == 0 ? fmt::format("All {} cases are the same", sections.size())
                                : fmt::format("{} of {} cases failed", bad, sections.size()));
  body += "<section><div class=\"scroll\"><table>\n";
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const GoldenSection& one = sections[i];
    const std::string name = escaped(one.name);
    body +=
        fmt::format("<tr><td>{}</td><td class=\"{}\">{}</td><td class=\"soft\">{}</td></tr>\n",
                    one.shown.empty() ? name : fmt::format("<a href=\"#case-{}\">{}</a>", i, name),
                    one.good ? "good" : "bad",
                    escaped(one.outcome),
                    escaped(one.note));
  }
  body += "</table></div></section>\n";
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const GoldenSection& one = sections[i];
    for (const ShownFrame& shown : one.shown) {
      body += fmt::format("<section id=\"case-{}\"><h2>{}</h2>\n", i, escaped(one.name));
      body += verdict_line(one.good, escaped(one.note.empty() ? one.outcome : one.note));
      body += frame_part(shown, one.thresholds) + "</section>\n";
    }
  }
  return whole_page(escaped(title), body);
}

}  // namespace polhode
