// SPDX-License-Identifier: MIT
#include "scene/keys.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "scene/scene.h"

namespace polhode {
// specs of a made-up file
struct Wheel {
  double radius = 1.0;
  std::optional<int> spokes;
};
template <class Visitor>
void fields(Visitor& v, Wheel& s) {
  v.required("radius", s.radius, Doc{"how large", Unit::length});
  v.field("spokes", s.spokes, Doc{"how many"});
}

struct Cart {
  std::vector<Wheel> wheels;
  Wheel spare;
  std::string name;
};
template <class Visitor>
void fields(Visitor& v, Cart& s) {
  v.exactly_one_of({"wheels", "spare"});
  v.field("wheels", s.wheels, Doc{"all of them"});
  v.field("spare", s.spare, Doc{"one more"});
  v.field("name", s.name, Doc{"what it is called"});
}
}  // namespace polhode

namespace polhode {
namespace {

TEST(Keys, AreThoseOfTheFieldsInTheirOrder) {
  const KeyList& list = keys_of<Cart>();
  ASSERT_EQ(list.keys.size(), 3u);
  EXPECT_EQ(list.keys[0].name, "wheels");
  EXPECT_TRUE(list.keys[0].many);
  EXPECT_FALSE(list.keys[1].many);
  ASSERT_TRUE(list.keys[0].inside && list.keys[1].inside);
  EXPECT_FALSE(list.keys[2].inside);
  EXPECT_TRUE(list.keys[0].inside->find("radius").required);
  EXPECT_FALSE(list.keys[0].inside->find("spokes").required);
  ASSERT_EQ(list.groups.size(), 1u);
  EXPECT_TRUE(list.groups[0].one_needed);
}

// one spelling for each unit, SI first
TEST(Keys, HaveOneSpellingForEachUnit) {
  const std::vector<std::string> all = keys_of<Wheel>().all_spellings();
  EXPECT_EQ(all.front(), "radius");
  EXPECT_EQ(all.back(), "spokes");
  EXPECT_NE(std::find(all.begin(), all.end(), "radius_cm"), all.end());
  EXPECT_EQ(all.size(), suffixes_of(Unit::length).size() + 1);
}

TEST(Keys, AreFoundInEveryTableThatHasThem) {
  using Names = std::vector<std::string>;
  const KeyList& list = keys_of<Cart>();
  EXPECT_EQ(tables_with("radius_mm", list), (Names{"[wheels[]]", "[spare]"}));
  EXPECT_EQ(tables_with("name", list), (Names{"the top of the file"}));
  EXPECT_TRUE(tables_with("radius_deg", list).empty());
  EXPECT_EQ(tables_with("fps", keys_of<Scene>()), (Names{"[video]"}));
}

// no two keys of one table can be written alike, or the reader could not tell them apart
void expect_distinct(const KeyList& list, const std::string& where) {
  std::vector<std::string> all = list.all_spellings();
  std::sort(all.begin(), all.end());
  const auto twice = std::adjacent_find(all.begin(), all.end());
  EXPECT_EQ(twice, all.end()) << where << ": " << *twice;
  for (const Key& key : list.keys) {
    EXPECT_FALSE(key.doc.text.empty()) << where << '.' << key.name;
    if (key.inside) expect_distinct(*key.inside, where + "." + key.name);
  }
  for (const KeyGroup& group : list.groups) {
    for (const std::string& name : group.names)
      EXPECT_EQ(list.find(name).name, name);
  }
}

TEST(Keys, OfAScenesTablesAreDistinctAndDocumented) {
  expect_distinct(keys_of<Scene>(), "scene");
}

}  // namespace
}  // namespace polhode
