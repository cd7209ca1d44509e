// SPDX-License-Identifier: MIT
#include "scene/schema.h"

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "base/json.h"
#include "scene/film_file.h"
#include "scene/keys.h"
#include "scene/scene.h"
#include "scene/to_json.h"

namespace polhode {
namespace {

// Names the type of a value whose schema is wanted.
template <class T>
struct Of {};

// bounds are kept in SI; the value of a suffixed key is in its own unit
Json number_schema(const std::string& type, const Range& allowed, const UnitSuffix& unit) {
  Json json{{"type", type}};
  const Range range = in_unit(within_magnitude(allowed, unit.unit), unit);
  if (std::isfinite(range.low)) json[range.low_open ? "exclusiveMinimum" : "minimum"] = range.low;
  if (std::isfinite(range.high)) json["maximum"] = range.high;
  return json;
}

Json list_schema(const Json& items, std::size_t least, std::optional<std::size_t> most) {
  Json json{{"type", "array"}, {"items", items}, {"minItems", least}};
  if (most) json["maxItems"] = *most;
  return json;
}

Json schema_of(Of<double>, const Doc& doc, const UnitSuffix& unit) {
  // JSON takes 1e6 for an integer
  return number_schema(doc.whole ? "integer" : "number", doc.range, unit);
}

Json schema_of(Of<int>, const Doc& doc, const UnitSuffix& unit) {
  return number_schema("integer", doc.range, unit);
}

Json schema_of(Of<bool>, const Doc&, const UnitSuffix&) {
  return {{"type", "boolean"}};
}

Json schema_of(Of<std::string>, const Doc& doc, const UnitSuffix&) {
  Json json{{"type", "string"}};
  if (!doc.choices.empty()) json["enum"] = doc.choices;
  if (doc.color) json["pattern"] = "^#[0-9a-fA-F]{6}$";
  return json;
}

template <int N>
Json schema_of(Of<Eigen::Matrix<double, N, 1>>, const Doc& doc, const UnitSuffix& unit) {
  Json json = list_schema(number_schema("number", doc.range, unit), N, N);
  // the only four-vector is a quaternion, which must not be zero
  if (N == 4) json["contains"] = Json{{"not", {{"const", 0}}}};
  return json;
}

Json schema_of(Of<Mat3>, const Doc& doc, const UnitSuffix& unit) {
  return list_schema(schema_of(Of<Vec3>{}, doc, unit), 3, 3);
}

template <int N>
Json schema_of(Of<std::vector<Eigen::Matrix<double, N, 1>>>,
               const Doc& doc,
               const UnitSuffix& unit) {
  return list_schema(schema_of(Of<Eigen::Matrix<double, N, 1>>{}, doc, unit), 1, std::nullopt);
}

Json schema_of(Of<std::vector<std::string>>, const Doc& doc, const UnitSuffix& unit) {
  return list_schema(schema_of(Of<std::string>{}, doc, unit), 1, kMostNames);
}

Json schema_of(Of<PictureSize>, const Doc&, const UnitSuffix& unit) {
  const Json side = number_schema("integer", Range{kSmallestSide, kLargestSide}, unit);
  const Json text{{"type", "string"}, {"pattern", "^[0-9]+x[0-9]+$"}};
  return {{"anyOf", Json::array({text, list_schema(side, 2, 2)})}};
}

Json schema_of(Of<FrameRate>, const Doc&, const UnitSuffix& unit) {
  const Json whole = number_schema("integer", Range{1}, unit);
  const Json ratio{{"type", "string"}, {"pattern", "^[0-9]+(/[0-9]+)?$"}};
  return {{"anyOf", Json::array({whole, ratio})}};
}

Json schema_of(Of<Accuracy>, const Doc&, const UnitSuffix& unit) {
  const Json radians = number_schema("number", kPositive, unit);
  const Json pixels{{"type", "string"}, {"pattern", "^[0-9]*\\.?[0-9]+([eE][+-]?[0-9]+)?(px)?$"}};
  return {{"anyOf", Json::array({radians, pixels})}};
}

Json schema_of(Of<toml::table>, const Doc&, const UnitSuffix&) {
  return {{"type", "object"}};
}

Json schema_of(Of<toml::array>, const Doc&, const UnitSuffix&) {
  const Json value{{"type", Json::array({"number", "string", "boolean"})}};
  return list_schema(value, 1, kMostNames);
}

// exactly one of these spellings is there; or none, where that is allowed
Json one_of(const std::vector<Spelling>& spellings, bool one_needed) {
  Json options = Json::array();
  for (const Spelling& spelling : spellings)
    options.push_back({{"required", Json::array({spelling.text})}});
  if (!one_needed) options.push_back({{"not", {{"anyOf", options}}}});
  return {{"oneOf", options}};
}

// The visitor that describes a spec as the schema of a JSON object.
class Describer {
 public:
  template <class T>
  void field(const char* name, T& member, const Doc& doc) {
    add(name, member, doc, false);
  }
  template <class T>
  void required(const char* name, T& member, const Doc& doc) {
    add(name, member, doc, true);
  }
  template <class A, class B>
  void merged(const char* name, A& a, B& b, const Doc& doc) {
    properties_[name] = Json{{"description", doc.text}};
    properties_[name].update(described(a, b));
  }
  // finished() has these from the key list
  void exactly_one_of(const std::vector<std::string>&) {}
  void at_most_one_of(const std::vector<std::string>&) {}

  // The schema of a table that holds all of these specs.
  template <class... Specs>
  static Json described(Specs&... specs) {
    Describer describer;
    (fields(describer, specs), ...);
    return describer.finished(keys_of<Specs...>());
  }

 private:
  template <class T>
  void add(const char* name, T& member, const Doc& doc, bool required) {
    const std::vector<Spelling> spellings = spellings_of(name, doc);
    for (const Spelling& spelling : spellings) {
      const std::string unit = spelling.unit.symbol;
      Json property{{"description", unit.empty() ? doc.text : doc.text + " (" + unit + ")"}};
      property.update(shape(member, doc, spelling.unit));
      properties_[spelling.text] = property;
    }
    if (!required) put_default(properties_[name], member);

    // one spelling at a time
    if (spellings.size() > 1) {
      rules_.push_back(one_of(spellings, required));
    } else if (required) {
      required_.push_back(name);
    }
  }

  template <class T>
  static Json shape(T& member, const Doc& doc, const UnitSuffix& unit) {
    if constexpr (IsSpec<T>) {
      return described(member);
    } else {
      return schema_of(Of<T>{}, doc, unit);
    }
  }
  template <class T>
  static Json shape(std::optional<T>&, const Doc& doc, const UnitSuffix& unit) {
    T value{};
    return shape(value, doc, unit);
  }
  template <class Spec>
  requires IsSpec<Spec>
  static Json shape(std::vector<Spec>&, const Doc&, const UnitSuffix&) {
    Spec spec;
    return list_schema(described(spec), 1, kMostTables);
  }

  // what an absent key means, where that is one value
  template <class T>
  static void put_default(Json& property, const T& member) {
    if constexpr (!IsSpec<T>) property["default"] = to_json_value(member);
  }
  template <class T>
  static void put_default(Json&, const std::optional<T>&) {}
  template <class T>
  static void put_default(Json&, const std::vector<T>&) {}
  static void put_default(Json&, const toml::table&) {}
  static void put_default(Json&, const toml::array&) {}

  Json finished(const KeyList& keys) {
    for (const KeyGroup& group : keys.groups) {
      std::vector<Spelling> spellings;
      for (const std::string& name : group.names) {
        for (const Spelling& spelling : spellings_of(name, keys.find(name).doc))
          spellings.push_back(spelling);
      }
      rules_.push_back(one_of(spellings, group.one_needed));
    }
    Json json{{"type", "object"}, {"additionalProperties", false}, {"properties", properties_}};
    if (!required_.empty()) json["required"] = required_;
    if (!rules_.empty()) json["allOf"] = rules_;
    return json;
  }

  Json properties_ = Json::object();
  Json required_ = Json::array();
  Json rules_ = Json::array();
};

Json head(const char* title) {
  return {{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", title}};
}

// A table that is merged with another need not be complete.
void remove_rules(Json& schema) {
  if (schema.is_object()) {
    schema.erase("required");
    schema.erase("allOf");
  }
  if (schema.is_structured()) {
    for (Json& inside : schema)
      remove_rules(inside);
  }
}

}  // namespace

Json scene_schema() {
  Scene scene;
  Json schema = head("Polhode scene, format 1");
  schema.update(Describer::described(scene));
  return schema;
}

Json film_schema() {
  FilmFile film;
  Json schema = head("Polhode film of several scenes, format 1");
  schema.update(Describer::described(film));
  Scene scene;
  Json all = Describer::described(scene);
  remove_rules(all);
  for (const auto& [key, value] : all["properties"].items()) {
    if (!schema["properties"].contains(key)) schema["properties"][key] = value;
  }
  return schema;
}

}  // namespace polhode
