// SPDX-License-Identifier: MIT
#include "export/gltf_scene.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "base/system/log.h"
#include "export/gltf_file.h"
#include "film/prepared_film.h"
#include "film/solved_scene.h"
#include "scene/scene_file.h"
#include "support/expect_error.h"
#include "support/scenes.h"

namespace polhode {
namespace {

Scene small_scene(const std::string& name) {
  Scene scene = load_scene(test::scene_path(name));
  scene.numerics.compare.clear();
  return scene;
}

const GltfNode* find(const GltfDocument& document, const std::string& name) {
  for (const GltfNode& node : document.nodes) {
    if (node.name == name) return &node;
  }
  return nullptr;
}

std::size_t count(const GltfDocument& document, const std::string& start) {
  return static_cast<std::size_t>(
      std::count_if(document.nodes.begin(), document.nodes.end(), [&](const GltfNode& node) {
        return node.name.starts_with(start);
      }));
}

TEST(GltfScene, HasWhatTheFilmShowsAndNamesEachNodeOnce) {
  for (const char* name : {"free_symmetric_top", "poinsot", "push_on_a_wheel", "book_ghosts"}) {
    const Solved solved = solve(small_scene(name));
    const ExportedScene exported = export_scene(solved, {});
    std::set<std::string> names;
    for (const GltfNode& node : exported.document.nodes)
      EXPECT_TRUE(names.insert(node.name).second) << node.name;
    for (const char* needed : {"body", "space", "body_frame", "camera", "along_omega"})
      EXPECT_EQ(names.count(needed), 1u) << name << ' ' << needed;
    EXPECT_LE(exported.report.error, exported.report.tolerance) << name;
    EXPECT_GT(exported.report.keys, 0u);
  }
}

TEST(GltfScene, SaysWhatItFollows) {
  ExportPlan plan;
  std::set<std::string> told;
  plan.tell = [&](const std::string& words) {
    told.insert(words.substr(0, words.find(" through")));
  };
  export_scene(solve(small_scene("free_symmetric_top")), plan);
  EXPECT_EQ(told.count("following omega"), 1u);
}

// the numbers of the file are of single precision: far away they are no finer
TEST(GltfScene, TellsWhatSinglePrecisionCosts) {
  Scene scene = small_scene("t_handle");
  scene.motion.velocity = Vec3(1e4, 0.0, 0.0);
  const Solved solved = solve(scene);
  const ExportedScene exported = export_scene(solved, {});
  const GltfNode* body = find(exported.document, "body_frame");
  ASSERT_NE(body, nullptr);
  ASSERT_TRUE(body->translated.times);
  const std::vector<float>& times = *body->translated.times;
  const std::vector<float>& places = *body->translated.values;
  double rounded = 0.0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double t = scene.video.time_scale * static_cast<double>(times[i]);
    rounded = std::max(rounded, std::abs(static_cast<double>(places[3 * i]) - 1e4 * t));
  }
  EXPECT_GT(rounded, 1e-3);
  EXPECT_GT(exported.report.error, rounded);
  EXPECT_LT(exported.report.error, 10.0 * rounded);
  EXPECT_GT(exported.report.error, exported.report.tolerance);
  EXPECT_NEAR(exported.report.farthest, 1e4 * solved.simulation.motion.duration(), 1.0);
}

// what is fixed in the body needs no motion of its own
TEST(GltfScene, WhatKeepsItsPlaceInTheBodyHangsBelowIt) {
  const GltfDocument document = export_scene(solve(small_scene("poinsot")), {}).document;
  const auto index_of = [&](const char* name) {
    return static_cast<int>(find(document, name) - document.nodes.data());
  };
  for (const char* name : {"body", "ellipsoid", "polhode"}) {
    const GltfNode* node = find(document, name);
    ASSERT_NE(node, nullptr) << name;
    EXPECT_EQ(node->parent, index_of("body_frame")) << name;
  }
  const GltfNode* arrow = find(document, "momentum.arrow");
  ASSERT_NE(arrow, nullptr);
  EXPECT_EQ(arrow->rotated.values, nullptr);  // L is constant
}

TEST(GltfScene, APathGrowsInPieces) {
  const GltfDocument document = export_scene(solve(small_scene("poinsot")), {}).document;
  EXPECT_GE(count(document, "herpolhode.path.piece"), 24u);
  float before = -1.0f;
  for (const GltfNode& node : document.nodes) {
    if (!node.name.starts_with("herpolhode.path.piece") || !node.scaled.times) continue;
    EXPECT_TRUE(node.scaled.steps);
    ASSERT_EQ(node.scaled.times->size(), 2u);
    EXPECT_EQ(node.scaled.values->front(), 0.0f);
    EXPECT_EQ(node.scaled.values->back(), 1.0f);
    EXPECT_GE((*node.scaled.times)[1], before);
    before = (*node.scaled.times)[1];
  }
}

// however short it is, a tail of that length follows the point
TEST(GltfScene, ATailIsAsLongAsAsked) {
  Scene scene = small_scene("free_symmetric_top");
  scene.show.asked["trail"] = true;
  for (const double length : {0.1, 0.3, 2.0}) {
    scene.show.trail_s = length;
    const GltfDocument document = export_scene(solve(scene), {}).document;
    int vanish = 0;
    for (const GltfNode& node : document.nodes) {
      if (!node.name.starts_with("trail.path.piece") || !node.scaled.times) continue;
      const std::vector<float>& times = *node.scaled.times;
      constexpr std::size_t kComesAndGoes = 3;
      if (times.size() < kComesAndGoes) continue;
      const double seen = (times[2] - times[1]) * scene.video.time_scale;
      EXPECT_GT(seen, 0.87 * length) << times[1];
      EXPECT_LT(seen, 1.001 * length) << times[1];
      ++vanish;
    }
    EXPECT_GT(vanish, 8) << length;
  }
  scene.show.trail_s = 1e-4;
  try {
    export_scene(solve(scene), {});
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.place().key, "show.trail_length");
  }
}

// the path of the contact on the body turns with it
TEST(GltfScene, APathOnTheBodyHangsBelowIt) {
  const GltfDocument document = export_scene(solve(small_scene("rattleback")), {}).document;
  std::set<std::string> parents;
  for (const GltfNode& node : document.nodes) {
    if (node.name.starts_with("contact_trail.path") && node.name.find("piece") == std::string::npos)
      parents.insert(document
                         .nodes[static_cast<std::size_t>(
                             document.nodes[static_cast<std::size_t>(node.parent)].parent)]
                         .name);
  }
  EXPECT_EQ(parents, (std::set<std::string>{"body_frame", "space"}));
  EXPECT_EQ(count(document, "contact_trail.mesh"), 0u);
}

// the copies of a thrown body come one after the other
TEST(GltfScene, WhatIsNotThereYetHasNoSize) {
  const GltfDocument document = export_scene(solve(small_scene("book_ghosts")), {}).document;
  ASSERT_GE(count(document, "ghosts.mesh"), 2u);
  for (const GltfNode& node : document.nodes) {
    if (!node.name.starts_with("ghosts.mesh")) continue;
    ASSERT_NE(node.scaled.values, nullptr) << node.name;
    EXPECT_EQ(node.scaled.values->front(), 0.0f);
    EXPECT_GT(node.scaled.values->back(), 0.0f);
  }
}

// a ring that grows with its cone would have a tube that grows, too
TEST(GltfScene, TheRimOfAConeKeepsItsThickness) {
  const GltfDocument document = export_scene(solve(small_scene("nutation_loops")), {}).document;
  double thinnest = 1e9, thickest = 0.0, smallest = 1e9, largest = 0.0;
  for (const GltfNode& node : document.nodes) {
    if (!node.name.starts_with("precession_cone.mesh") || node.mesh < 0) continue;
    double low = 0.0, high = 0.0, tube = 0.0;
    for (const Vertex& vertex :
         document.meshes[static_cast<std::size_t>(node.mesh)].mesh->vertices) {
      low = std::min<double>(low, vertex.position.z);
      high = std::max<double>(high, vertex.position.z);
      tube = std::max<double>(tube, std::hypot(vertex.position.x, vertex.position.y) - 1.0);
    }
    const bool is_ring = low == -high;
    if (!is_ring || node.scaled.values == nullptr) continue;
    for (std::size_t i = 2; i < node.scaled.values->size(); i += 3) {
      const double across = (*node.scaled.values)[i];
      if (across == 0.0) continue;  // another one takes its turn
      thinnest = std::min(thinnest, across * tube);
      thickest = std::max(thickest, across * tube);
      smallest = std::min(smallest, across);
      largest = std::max(largest, across);
    }
  }
  EXPECT_GT(largest, 1.5 * smallest) << "the cone opens and closes";
  // steps of a tenth, and what polygons lack of circles
  EXPECT_LT(thickest, 1.15 * thinnest);
}

TEST(GltfScene, TheCameraOfAViewFromTheBodyTurnsWithIt) {
  Scene scene = small_scene("free_symmetric_top");
  const auto camera_turns = [&] {
    const GltfDocument document = export_scene(solve(scene), {}).document;
    return std::any_of(document.nodes.begin(), document.nodes.end(), [](const GltfNode& node) {
      return node.name.starts_with("camera") && node.rotated.values != nullptr;
    });
  };
  EXPECT_FALSE(camera_turns());
  scene.show.views = {"body"};
  EXPECT_TRUE(camera_turns());
}

// of a film that repeats, the automatic camera shows what the film does
TEST(GltfScene, TheCameraOfALoopIsThatOfItsFilm) {
  Scene scene = small_scene("spherical_top");
  scene.show["fixed_frame"] = true;
  scene.motion.velocity = Vec3(0.0, 0.1, 0.0);
  scene.motion.spin = {};
  scene.motion.spin.space = Vec3(0.0, 0.0, 2.0 * kPi);
  scene.motion.duration = 5.0;
  const auto camera = [&] {
    const GltfDocument document = export_scene(solve(scene), {}).document;
    return find(document, "camera")->translation;
  };
  const Vec3 whole = camera();
  scene.video.loop = true;
  const Vec3 round = camera();
  EXPECT_GT((whole - round).norm(), 0.05 * round.norm());
  RenderPlan plan;
  plan.scene = scene;
  plan.text = true;
  const PreparedFilm film(plan);
  const Vec3 eye = film.film().panels().front().composer->camera_at(0.0).eye();
  EXPECT_LT((round - eye).norm(), 1e-6 * eye.norm());
}

TEST(GltfScene, TheMotionMayBePartOnly) {
  const Solved solved = solve(small_scene("free_symmetric_top"));
  ExportPlan plan;
  plan.from = 2.0;
  plan.to = 3.0;
  const GltfDocument part = export_scene(solved, plan).document;
  EXPECT_EQ(find(part, "body_frame")->rotated.times->back(), 1.0f);
  const Quat exact = solved.simulation.motion.at(2.0).q_SB;
  EXPECT_LT(find(part, "body_frame")->rotation.angularDistance(exact), 1e-12);
  plan.to = 99.0;
  test::expect_error([&] { export_scene(solved, plan); }, Fault::input, "--to", "");
}

// molecules and planets are as large as things on a table
TEST(GltfScene, ScenesOfAnySizeAreSeenByViewers) {
  const GltfDocument document = export_scene(solve(small_scene("earth_precession")), {}).document;
  const double unit = document.extras.at("units_per_metre");
  EXPECT_NEAR(unit * double(document.extras.at("body_radius")), 1.0, 1e-12);
  EXPECT_EQ(find(document, "space")->scale, Vec3::Constant(unit));
}

// words of a scene are words of the file
TEST(GltfScene, HostileTextsStayTexts) {
  Scene scene = small_scene("free_symmetric_top");
  scene.title = "</script>\"\\\n\x01";
  scene.show.names = VectorNames{};
  scene.show.names->omega = "<img onerror=x>\"";
  const std::string bytes = glb_of(export_scene(solve(scene), {}).document);
  const std::uint32_t length = *reinterpret_cast<const std::uint32_t*>(bytes.data() + 12);
  const nlohmann::json read = nlohmann::json::parse(bytes.substr(20, length));
  EXPECT_EQ(read.at("asset").at("extras").at("title"), scene.title);
  bool seen = false;
  for (const auto& node : read.at("nodes")) {
    if (node.value("name", "") != "omega.label") continue;
    EXPECT_EQ(node.at("extras").at("label"), "<b>&lt;img onerror=x&gt;&quot;</b>");
    seen = true;
  }
  EXPECT_TRUE(seen);
}

}  // namespace
}  // namespace polhode
