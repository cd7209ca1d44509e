// SPDX-License-Identifier: MIT
// Writes structs to JSON and reads them back, from one list of fields per struct:
//
//   template <class Visitor> void report_fields(Visitor& v, Struct& s) {
//     v.field("key", s.member);       // always there; absent optionals are null
//     v.optional("key", s.member);    // left out when the std::optional is absent
//     v.derived("key", value);        // written for people, not read back
//   }
//
// json_of(s) writes, read_json(json, s) reads. Members may be structs with such a list, lists and
// optionals of writable values, frame rates, JSON, and what nlohmann::json converts by itself.
#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

#include "base/at_place.h"
#include "base/error.h"
#include "base/json.h"
#include "base/system/stage_clock.h"
#include "video/video_spec.h"

namespace polhode {

class JsonWriter;
class JsonReader;

// A struct that has report_fields().
template <class T>
concept ListsFields = requires(JsonWriter& v, T& s) {
  report_fields(v, s);
};

// Defined below.
template <class T>
Json json_of(T value);

// Visitor that collects the fields of a struct as a JSON object, in the order of its list.
class JsonWriter {
 public:
  template <class T>
  void field(const char* key, const T& value) {
    json_[key] = json_of(value);
  }
  template <class T>
  void optional(const char* key, const std::optional<T>& value) {
    if (value) field(key, *value);
  }
  template <class T>
  void derived(const char* key, const T& value) {
    field(key, value);
  }
  // The object so far; valid as long as the writer.
  const Json& json() const { return json_; }

 private:
  Json json_ = Json::object();
};

// Sets a value from JSON, by its type. A list or an optional replaces the old value; null makes an
// optional absent. Throws nlohmann::json::exception for a value of the wrong type or a missing key
// of a struct, and Error (input), with the key of the struct, for an integer that is out of range
// and as parse_frame_rate does.
inline void read_json(const Json& json, Json& value) {
  value = json;
}
inline void read_json(const Json& json, FrameRate& value) {
  value = parse_frame_rate(json.get<std::string>());
}
template <class T>
void read_json(const Json& json, T& value);
template <class T>
void read_json(const Json& json, std::optional<T>& value);
template <class T>
void read_json(const Json& json, std::vector<T>& value);

// Visitor that sets the fields of a struct from a JSON object; unknown keys are ignored. Throws as
// read_json does, also for a missing key.
class JsonReader {
 public:
  // `json` must outlive the reader.
  explicit JsonReader(const Json& json) : json_(json) {}

  template <class T>
  void field(const char* key, T& value) {
    const Json& found = json_.at(key);
    at_place({{}, 0, key}, [&] { read_json(found, value); });
  }
  template <class T>
  void optional(const char* key, std::optional<T>& value) {
    if (json_.contains(key)) field(key, value.emplace());
  }
  template <class T>
  void derived(const char*, const T&) {}

 private:
  const Json& json_;
};

// The overloads behind json_of(); a frame rate becomes the text "30000/1001".
inline Json json_value(const FrameRate& rate) {
  return fmt::format("{}/{}", rate.numerator, rate.denominator);
}
template <class T>
Json json_value(const std::optional<T>& value) {
  return value ? json_of(*value) : Json(nullptr);
}
template <class T>
Json json_value(const std::vector<T>& values) {
  Json list = Json::array();
  for (const T& value : values)
    list.push_back(json_of(value));
  return list;
}
template <class T>
requires(!ListsFields<T>) Json json_value(const T& value) {
  return value;
}
template <ListsFields T>
Json json_value(T& value) {
  JsonWriter writer;
  report_fields(writer, value);
  return writer.json();
}

// A value as JSON: a struct with report_fields() as an object, a std::vector as a list, an absent
// optional as null, any other value as nlohmann::json converts it.
template <class T>
Json json_of(T value) {
  return json_value(value);
}

template <class T>
void read_json(const Json& json, T& value) {
  if constexpr (requires(JsonReader & v) { report_fields(v, value); }) {
    JsonReader reader(json);
    report_fields(reader, value);
  } else {
    json.get_to(value);
    // nlohmann::json cuts off what an integer cannot hold
    if constexpr (std::is_integral_v<T>) {
      if (json != Json(value)) throw input_error("{} is out of range", json.dump());
    }
  }
}
template <class T>
void read_json(const Json& json, std::optional<T>& value) {
  value.reset();
  if (!json.is_null()) read_json(json, value.emplace());
}
template <class T>
void read_json(const Json& json, std::vector<T>& value) {
  value.clear();
  for (const Json& one : json)
    read_json(one, value.emplace_back());
}

// Lists the keys of the time of a stage, in seconds.
template <class Visitor>
void report_fields(Visitor& v, StageTime& s) {
  v.field("wall_s", s.wall_s);
  v.field("cpu_s", s.cpu_s);
}

}  // namespace polhode
