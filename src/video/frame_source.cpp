// SPDX-License-Identifier: MIT
#include "video/frame_source.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "base/error.h"
#include "base/system/atomic_file.h"
#include "base/system/files.h"
#include "base/system/overwriting.h"
#include "image/png.h"
#include "video/film_reader.h"
#include "video/png_sink.h"

namespace polhode {
namespace fs = std::filesystem;
namespace {

// files that are there, one picture each
class PictureSource final : public FrameSource {
 public:
  struct Entry {
    std::string label;
    fs::path file;
  };

  PictureSource(SourceKind kind, std::vector<Entry> entries) : entries_(std::move(entries)) {
    info_.kind = kind;
    for (const Entry& entry : entries_) {
      protect_file(entry.file);
      info_.labels.push_back(entry.label);
    }
    info_.frames = static_cast<int>(entries_.size());
  }
  const SourceInfo& info() const override { return info_; }
  bool next(SourceFrame& frame) override {
    if (next_ == entries_.size()) return false;
    const Entry& entry = entries_[next_++];
    frame.image = read_png(entry.file);
    frame.label = entry.label;
    frame.time = 0.0;
    return true;
  }

 private:
  SourceInfo info_;
  std::vector<Entry> entries_;
  std::size_t next_ = 0;
};

class FilmSource final : public FrameSource {
 public:
  explicit FilmSource(const std::string& name) : reader_(name) {
    protect_file(name);
    info_.kind = SourceKind::film;
    info_.fps = reader_.info().fps;
    info_.frames = reader_.info().frames;
  }
  const SourceInfo& info() const override { return info_; }
  bool next(SourceFrame& frame) override {
    frame.label.clear();
    return reader_.next(frame.image, frame.time);
  }

 private:
  FilmReader reader_;
  SourceInfo info_;
};

// whether it is a PNG file without what makes it an animation, which comes before the pixels
bool has_one_frame(const std::string& name) {
  const std::string head = head_of_file(name, std::size_t{1} << 20U);
  return head.starts_with("\x89PNG") && !is_animation(head);
}

// files of a folder; nothing when it cannot be read
std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files = entries_of(folder);
  std::erase_if(files, [](const fs::path& file) {
    std::error_code ignored;
    return !fs::is_regular_file(file, ignored);
  });
  return files;
}

// f2 before f10: runs of digits are compared as numbers
bool comes_before(const std::string& a, const std::string& b) {
  const auto digit = [](char c) {
    return c >= '0' && c <= '9';
  };
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (!digit(a[i]) || !digit(b[j])) {
      if (a[i] != b[j]) return a[i] < b[j];
      ++i, ++j;
      continue;
    }
    const auto run = [&](const std::string& text, std::size_t& at) {
      while (at < text.size() && text[at] == '0')
        ++at;
      const std::size_t start = at;
      while (at < text.size() && digit(text[at]))
        ++at;
      return text.substr(start, at - start);
    };
    const std::string one = run(a, i), other = run(b, j);
    if (one.size() != other.size()) return one.size() < other.size();
    if (one != other) return one < other;
  }
  if (i < a.size() || j < b.size()) return i == a.size();
  return a < b;
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  return text;
}

std::unique_ptr<FrameSource> open_folder(const std::string& name) {
  std::vector<PictureSource::Entry> entries;
  for (const fs::path& file : files_in(name)) {
    if (lower(file.extension().string()) == ".png") {
      entries.push_back({file.filename().string(), file});
    }
  }
  if (entries.empty()) throw input_error("contains no .png files").at({name, 0, {}});
  std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
    return comes_before(a.label, b.label);
  });
  return std::make_unique<PictureSource>(SourceKind::folder, std::move(entries));
}

// Whether the pattern would write a number so; numbers may have any size, as times do.
bool is_number_of(const NumberedName& pattern, const std::string& digits) {
  const auto width = static_cast<std::size_t>(std::max(1, pattern.width));
  return digits.find_first_not_of("0123456789") == std::string::npos &&
         (digits.size() == width || (digits.size() > width && digits[0] != '0'));
}

std::unique_ptr<FrameSource> open_numbered(const std::string& name) {
  const NumberedName pattern = parse_numbered_name(name);
  const fs::path folder = fs::path(name).has_parent_path() ? fs::path(name).parent_path() : ".";
  const std::string before = fs::path(pattern.before).filename().string();
  std::vector<PictureSource::Entry> entries;
  std::error_code failed;
  if (!fs::is_directory(folder, failed)) {
    throw input_error("the folder '{}' does not exist", folder.string()).at({name, 0, {}});
  }
  for (const fs::path& file : files_in(folder)) {
    const std::string found = file.filename().string();
    if (found.size() <= before.size() + pattern.after.size() || !found.starts_with(before) ||
        !found.ends_with(pattern.after)) {
      continue;
    }
    const std::string digits =
        found.substr(before.size(), found.size() - before.size() - pattern.after.size());
    if (!is_number_of(pattern, digits)) continue;
    // without zeros before it, by which pictures have their partners
    const std::size_t first = std::min(digits.find_first_not_of('0'), digits.size() - 1);
    entries.push_back({digits.substr(first), pattern.before + digits + pattern.after});
  }
  if (entries.empty()) throw input_error("the picture does not exist").at({name, 0, {}});
  std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
    return comes_before(a.label, b.label);
  });
  return std::make_unique<PictureSource>(SourceKind::numbered, std::move(entries));
}

}  // namespace

std::unique_ptr<FrameSource> open_frames(const std::string& name) {
  std::error_code ignored;
  if (fs::is_directory(name, ignored)) return open_folder(name);
  const bool there = fs::exists(name, ignored);
  const std::string ending = lower(fs::path(name).extension().string());
  if (!there && has_frame_number(name) && ending == ".png") return open_numbered(name);
  if (!there) throw input_error("the file does not exist").at({name, 0, {}});
  // an animation of one frame is a picture
  const bool is_picture = ending == ".png" || (ending == ".apng" && has_one_frame(name));
  if (is_picture) {
    return std::make_unique<PictureSource>(SourceKind::picture,
                                           std::vector<PictureSource::Entry>{{"", name}});
  }
  if (has_film_ending(lower(name))) return std::make_unique<FilmSource>(name);
  throw input_error(
      "is not a picture (.png), numbered sequence (name_%05d.png), folder of pictures, film (.mp4, "
      ".mkv, .mov, .webm, .gif, .apng, .avi) or scene (.toml)")
      .at({name, 0, {}});
}

}  // namespace polhode
