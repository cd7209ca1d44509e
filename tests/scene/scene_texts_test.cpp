// SPDX-License-Identifier: MIT
#include "scene/scene_texts.h"

namespace polhode {
namespace {

// the contract of the scene format, with every table
const char* const kEveryTable = R"(format = 1
title = "Free precession of a symmetric top"   # a comment

[body]
moments = [1.0, 1.0, 1.8]
about = "center"
mathematical = false
mass = 1.0
center_of_mass = [0, 0, 0]
pivot = [0, 0, 0]
look = { kind = "lathe", profile = [[0, 0], [0.4, 0.3], [0.05, 0.5]], color = "#Ff8800" }

[motion]
hold = "free"
gravity = [0, 0, -9.81]
duration = 10.0
attitude = { zxz_deg = [0, 20, 0] }
spin = { body = [0.3, 0, 5.0] }
position = [0, 0, 0]
velocity = [0, 0, 0]

[numerics]
model = "auto"
method = "auto"
step = 0.001
tolerance = 1e-9
accuracy = "0.1px"

[camera]
eye = [3, 0, 1]
target = [0, 0, 0]
fov_deg = 30

[show]
body = true
axes = true
space_axes = false
omega = true
momentum = true
space_cone = true
body_cone = true
precession_cone = false
pivot = false

[video]
size = "1920x1080"
fps = 60
time_scale = 0.5
theme = "dark"
background = "#102030"
)";

// Each function is one table: name, text, line, key, part of the message, "false" when no schema
// can see it.
// clang-format off
std::vector<BadSceneText> unknown_keys() {
  return {
      {"typo", "[body]\nmomemts = [1, 2, 3]\n", 2, "body.momemts", "did you mean 'moments'?"},
      {"typo of a suffixed key", "[body.solid]\nkind = \"sphere\"\nradius_cn = 3\n",
       3, "body.solid.radius_cn", "did you mean 'radius_cm'?"},
      {"a unit that a key does not have", kBody + "[motion]\nduration_s = 2\n",
       4, "motion.duration_s", "unknown key (did you mean 'duration' in s, 'duration_ms' in ms"},
      {"a unit that is unknown", "[body]\nsolid = { kind = \"sphere\", radius_in = 3 }\n",
       2, "body.solid.radius_in", "(did you mean 'radius' in m, 'radius_mm' in mm, 'radius_cm' in cm, 'radius_km' in km?)"},
      {"typo in a list", "[body]\nparts = [\n{ kind = \"rod\" },\n{ kind = \"rod\", mas = 1 },\n]\n",
       4, "body.parts[1].mas", "did you mean 'mass'?"},
      {"typo of a table", kBody + "[vidoe]\nfps = 60\n", 3, "vidoe", "did you mean 'video'?"},
      {"another table's key", kBody + "fps = 60\n",
       3, "body.fps", "unknown key here; 'fps' is a key of [video]"},
      {"another table's suffixed key", kBody + "[motion]\nradius_cm = 1\n",
       4, "motion.radius_cm", "'radius_cm' is a key of body.solid and body.parts[] and body.look"},
      {"a top key in a table", "[body]\nformat = 1\n",
       2, "body.format", "'format' is a key of the top of the file"},
      {"nothing near", kBody + "[show]\nxylophone = true\n",
       4, "show.xylophone", "(known: body, ghosts, ensemble, axes, "},
      {"another kind of value", kBody + "[motion]\nfriction = 0.1\n", 4, "motion.friction",
       "must be a table; found the number 0.1 (here it is motion.friction = { kind = \"coulomb\""},
      {"a word for a choice", kBody + "[motion]\ntorque = [{ kind = \"friction\", c = 1 }]\n",
       4, "motion.torque[0].kind", "or motion.torque = [{ kind = \"damping\", c = ... }]"},
      {"a word that is near another", kBody + "[motion]\nprecession = 3\n", 4, "motion.precession", "steady = \"slow\""},
      {"another word with a unit", kBody + "[motion]\nangle_deg = 3\n", 4, "motion.angle_deg", "here it is motion.attitude"},
      {"a key that begins with another word", kBody + "[video]\ntime_scal = 3\n", 4, "video.time_scal", "did you mean 'time_scale'?"},
      {"first by line", kBody + "[video]\nzzz = 1\naaa = 2\n", 4, "video.zzz", "unknown key"},
      {"unit that the key has not", "[body]\nmoments_cm = [1, 2, 3]\n",
       2, "body.moments_cm", "did you mean 'moments' in kg m^2"},
      {"key that needs quotes", kBody + "\"a.b c\" = 1\n", 3, "body.\"a.b c\"", "unknown key"},
      {"case matters", "[Body]\nmoments = [1, 2, 3]\n", 1, "Body", "did you mean 'body'?"},
      {"two spellings", "[body.solid]\nkind = \"sphere\"\nradius = 1\nradius_cm = 3\n",
       4, "body.solid.radius_cm", "give only one of radius and radius_cm"},
  };
}

std::vector<BadSceneText> wrong_types() {
  return {
      {"text for a number", kBody + "mass = \"1.0\"\n",
       3, "body.mass", "must be a number, such as 1.5; found the text \"1.0\""},
      {"flag for a number", kBody + "mass = true\n", 3, "body.mass", "found true"},
      {"list for a number", kBody + "mass = [1]\n", 3, "body.mass", "found a list of 1"},
      {"table for a number", kBody + "mass = { m = 1 }\n", 3, "body.mass", "found a table"},
      {"date for a number", kBody + "mass = 1979-05-27\n", 3, "body.mass", "found a date or time"},
      {"number for text", "title = 3\n" + kBody,
       1, "title", "must be text, such as \"a title\"; found the number 3"},
      {"number for a flag", kBody + "[show]\naxes = 1\n",
       4, "show.axes", "must be true or false; found the number 1"},
      {"text for a flag", kBody + "[show]\ntitle = \"A top\"\n",
       4, "show.title", "found the text \"A top\"; 'title' is also a key of the top of the file"},
      {"vector for a flag", kBody + "[show]\ngravity = [0, 0, -1]\n",
       4, "show.gravity", "found a list of 3; 'gravity' is also a key of [motion]"},
      {"text for a flag that is a table elsewhere", kBody + "[show]\nbody = \"red\"\n",
       4, "show.body", "must be true or false; found the text \"red\""},
      {"number for a table", "body = 3\n", 1, "body", "must be a table; found the number 3"},
      {"list for a table", "[[body]]\nmoments = [1, 2, 3]\n",
       1, "body", "must be a table; found a list of 1"},
      {"table for a list", "[body.parts]\nkind = \"rod\"\n",
       1, "body.parts", "must be a list of tables"},
      {"number in a list of tables", "[body]\npoints = [\n3]\n",
       3, "body.points[0]", "must be a table; found the number 3"},
      {"number for a vector", "[body]\nmoments = 3\n",
       2, "body.moments", "must be a list of three numbers"},
      {"text in a vector", "[body]\nmoments = [1,\n \"2\", 3]\n",
       3, "body.moments[1]", "must be a number"},
      {"float for a whole number", "format = 1.5\n" + kBody,
       1, "format", "must be a whole number, such as 1; found the number 1.5"},
      {"fraction of a step", kBody + "[numerics]\nmax_steps = 1.5\n",
       4, "numerics.max_steps", "must be a whole number, got 1.5"},
  };
}

std::vector<BadSceneText> wrong_lengths() {
  return {
      {"short vector", "[body]\nmoments = [1, 2]\n",
       2, "body.moments", "must be a list of three numbers, such as [1, 0, 0.5]; found a list of 2"},
      {"long vector", "[body]\nmoments = [1, 2, 3, 4]\n", 2, "body.moments", "found a list of 4"},
      {"short row", "[body]\ntensor = [[1, 0, 0],\n[0, 1],\n[0, 0, 1]]\n",
       3, "body.tensor[1]", "found a list of 2"},
      {"missing row", "[body]\ntensor = [[1, 0, 0], [0, 1, 0]]\n",
       2, "body.tensor", "must be three rows"},
      {"no parts", "[body]\nparts = []\n", 2, "body.parts", "found an empty list"},
      {"flat profile", "[body]\nsolid = { kind = \"lathe\", profile = [0, 1] }\n",
       2, "body.solid.profile[0]", "must be a list of two numbers"},
      {"empty profile", "[body]\nsolid = { kind = \"lathe\", profile = [] }\n",
       2, "body.solid.profile", "found an empty list"},
  };
}

std::vector<BadSceneText> out_of_range() {
  return {
      {"negative mass", kBody + "mass = -1\n", 3, "body.mass", "must be greater than 0, got -1"},
      {"no mass", kBody + "mass_g = 0\n", 3, "body.mass_g", "must be greater than 0, got 0"},
      {"negative moment", "[body]\nmoments = [1, 2, -3]\n",
       2, "body.moments[2]", "must be at least 0, got -3"},
      {"wide camera", kBody + "[camera]\nfov_deg = 180\n",
       4, "camera.fov_deg", "must be at most 148.969, got 180"},
      {"narrow camera", kBody + "[camera]\nfov = 0.001\n",
       4, "camera.fov", "must be at least 0.01, got 0.001"},
      {"unknown format", "format = 2\n" + kBody, 1, "format", "must be 1, got 2"},
      {"huge format", "format = 9223372036854775807\n" + kBody, 1, "format", "must be 1, got"},
      {"lowest format", "format = -9223372036854775808\n" + kBody, 1, "format", "must be 1, got"},
      {"infinite mass", kBody + "mass = inf\n",
       3, "body.mass", "must be a finite number, got inf", false},
      {"no number", "[body]\nmoments = [1, nan, 1]\n",
       2, "body.moments[1]", "must be a finite number, got nan", false},
      {"negative infinity", kBody + "[motion]\ngravity = [0, 0, -inf]\n",
       4, "motion.gravity[2]", "got -inf", false},
      {"infinite after the unit", kBody + "[motion]\nduration_d = 1e308\n",
       4, "motion.duration_d", "is too large to be computed with (the limit is 1.15741e+10 d), got 1e+308"},
  };
}

std::vector<BadSceneText> wrong_names() {
  return {
      {"unknown solid", "[body]\nsolid = { kind = \"bxo\" }\n",
       2, "body.solid.kind", "'bxo' is not known (did you mean 'box'?)"},
      {"unknown hold", kBody + "[motion]\nhold = \"pivto\"\n",
       4, "motion.hold", "did you mean 'pivot'?"},
      {"unknown about", kBody + "about = \"somewhere else\"\n",
       3, "body.about", "(known: center, pivot)"},
      {"unknown theme", kBody + "[video]\ntheme = \"drak\"\n",
       4, "video.theme", "did you mean 'dark'?"},
      {"unknown method", kBody + "[numerics]\nmethod = \"atuo\"\n",
       4, "numerics.method", "did you mean 'auto'?"},
      {"unknown model", kBody + "[numerics]\nmodel = \"atuo\"\n",
       4, "numerics.model", "did you mean 'auto'?"},
      {"short colour", "[body]\nsolid = { kind = \"sphere\", color = \"#fff\" }\n",
       2, "body.solid.color", "must be a colour \"#rrggbb\""},
      {"named colour", kBody + "[video]\nbackground = \"black\"\n",
       4, "video.background", "found \"black\""},
      {"not hex", kBody + "[video]\nbackground = \"#00000g\"\n",
       4, "video.background", "must be a colour"},
  };
}

std::vector<BadSceneText> missing_and_exclusive_keys() {
  return {
      {"no body", "title = \"x\"\n", 0, "body", "this table is missing (how the mass of the body is distributed, and how it looks)"},
      {"empty body", "\n[body]\n",
       2, "body", "give exactly one of moments, tensor, points, solid, parts; found none"},
      {"two bodies", "[body]\nmoments = [1, 2, 3]\nsolid = { kind = \"sphere\" }\n",
       3, "body", "give exactly one of moments, tensor, points, solid, parts; found moments and solid"},
      {"two bodies, suffixed", "[body]\nmoments_g_cm2 = [1, 2, 3]\ntensor = 3\n",
       3, "body", "found moments_g_cm2 and tensor"},
      {"two attitudes", kBody + "[motion]\nattitude = { zxz_deg = [1, 2, 3], quaternion = [1, 0, 0, 0] }\n",
       4, "motion.attitude", "give exactly one of zxz, quaternion, tilt, momentum_up; found zxz_deg and quaternion"},
      {"two spins", kBody + "[motion.spin]\nbody = [1, 2, 3]\nspace_rpm = [1, 2, 3]\n",
       5, "motion.spin", "found body and space_rpm"},
      {"no kind", "[body]\nsolid = { radius = 1 }\n",
       2, "body.solid.kind", "this key is missing (shape of the solid: box, sphere"},
      {"no kind in parts", "[[body.parts]]\nkind = \"rod\"\n[[body.parts]]\nmass = 1\n",
       3, "body.parts[1].kind", "this key is missing"},
      {"point without mass", "[body]\npoints = [{ at = [1, 2, 3] }]\n",
       2, "body.points[0].m", "this key is missing (mass of the point)"},
      {"point without place", "[body]\npoints = [{ m_g = 1 }]\n",
       2, "body.points[0].at", "this key is missing"},
      {"empty spin", kBody + "[motion]\nspin = {}\n",
       4, "motion.spin", "give exactly one of body, space, momentum_body, rates, steady, sleeping; found none"},
      {"absurd length", "[body]\nsolid = { kind = \"sphere\", radius = 1e300, mass = 1 }\n",
       2, "body.solid.radius", "is too large to be computed with (the limit is 1e+15 m), got 1e+300"},
      {"absurd mass", "[body]\nsolid = { kind = \"sphere\", radius = 1, mass = 1e-200 }\n",
       2, "body.solid.mass", "is too small to be computed with (the limit is 1e-30 kg), got 1e-200"},
      {"absurd spin", kBody + "[motion]\nspin = { body = [0, 0, 1e160] }\n",
       4, "motion.spin.body[2]", "is too large"},
      {"absurd quaternion", kBody + "[motion]\nattitude = { quaternion = [1e200, 0, 0, 1e200] }\n",
       4, "motion.attitude.quaternion[0]", "is too large"},
      {"faster than light", kBody + "[motion]\nvelocity = [3e8, 0, 0]\n",
       4, "motion.velocity[0]", "the limit is 2.99792e+08 m/s"},
      {"two ways to place the camera", kBody + "[camera]\neye = [1, 0, 0]\ndirection = [1, 0, 0]\n",
       5, "camera", "give at most one of eye, direction"},
      {"too many points", "[body]\npoints = [" + repeated("{ m = 1, at = [1, 2, 3] }, ", 1001) + "]\n",
       2, "body.points", "has 1001 tables; at most 1000 are allowed"},
      {"zero quaternion", kBody + "[motion]\nattitude = { quaternion = [0, 0.0, 0, -0.0] }\n",
       4, "motion.attitude.quaternion", "must not be zero in all four numbers"},
  };
}

std::vector<BadSceneText> wrong_video_and_accuracy() {
  return {
      {"huge size", kBody + "[video]\nsize = [1000000000, 3]\n",
       4, "video.size[0]", "must be at most 16384, got 1000000000"},
      {"float size", kBody + "[video]\nsize = [1e9, 3]\n",
       4, "video.size[0]", "must be a whole number"},
      {"huge size", kBody + "[video]\nsize = [16384, 16384]\n",
       4, "video.size", "at most 67108864 pixels", false},
      {"tiny size", kBody + "[video]\nsize = [640, 3]\n",
       4, "video.size[1]", "must be at least 16, got 3"},
      {"size of three", kBody + "[video]\nsize = [640, 480, 3]\n",
       4, "video.size", "must be a picture size, such as \"1920x1080\" or [1920, 1080]; found a list of 3"},
      {"size as a number", kBody + "[video]\nsize = 1080\n",
       4, "video.size", "found the number 1080"},
      {"size in words", kBody + "[video]\nsize = \"large\"\n", 4, "video.size", ""},
      {"ntsc", kBody + "[video]\nfps = 29.97\n",
       4, "video.fps", "rates are exact: write \"30000/1001\" instead of 29.97"},
      {"film on tv", kBody + "[video]\nfps = 23.976\n", 4, "video.fps", "write \"24000/1001\""},
      {"half frames", kBody + "[video]\nfps = 12.5\n", 4, "video.fps", "write \"25/2\""},
      {"infinite rate", kBody + "[video]\nfps = inf\n", 4, "video.fps", "not a frame rate", false},
      {"zero rate", kBody + "[video]\nfps = 0\n", 4, "video.fps", ""},
      {"rate in words", kBody + "[video]\nfps = \"fast\"\n", 4, "video.fps", ""},
      {"rate as a list", kBody + "[video]\nfps = [60]\n",
       4, "video.fps", "must be a whole number, such as 60, or an exact ratio"},
      {"zero accuracy", kBody + "[numerics]\naccuracy = 0\n",
       4, "numerics.accuracy", "must be greater than 0, got 0"},
      {"infinite accuracy", kBody + "[numerics]\naccuracy = inf\n",
       4, "numerics.accuracy", "must be a finite number", false},
      {"accuracy in feet", kBody + "[numerics]\naccuracy = \"3 feet\"\n",
       4, "numerics.accuracy", ""},
      {"accuracy as a flag", kBody + "[numerics]\naccuracy = true\n",
       4, "numerics.accuracy", "must be radians, such as 1e-6, or pixels, such as \"0.1px\"; found true"},
  };
}

// clang-format on

}  // namespace

std::vector<SceneText> good_scenes() {
  return {
      {"every table", kEveryTable},
      {"the least", "[body]\nmoments = [1, 2, 3]\n"},
      {"windows",
       "\xEF\xBB\xBF"
       "title = \"\xC3\xA9\"\r\n[body]\r\nmoments = [1, 2, 3]\r\n"},
      {"tensor", "[body]\ntensor = [[1, 0, 0], [0, 1.5, 0.1], [0, 0.1, 2]]\n"},
      {"tensor in g cm^2", "[body]\ntensor_g_cm2 = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\n"},
      {"points",
       "[body]\npoints = [{ m = 1, at = [0, 0, 1] }, { m_g = 5, at_mm = [0, 0, -100] }]\n"},
      {"solid",
       "[body]\nsolid = { kind = \"box\", size_cm = [1, 2, 3], density_g_per_cm3 = 2.7 }\n"},
      {"solid as a table", "[body.solid]\nkind = \"sphere\"\nradius_mm = 12.5\nmass_g = 8\n"},
      {"dotted keys",
       "body.solid.kind = \"sphere\"\nbody.solid.radius = 0.5\nbody.solid.mass = 1\n"},
      {"parts",
       "[[body.parts]]\nkind = \"rod\"\nlength = 1\nmass = 2\n"
       "[[body.parts]]\nkind = \"ring\"\nradius = 1\ntube = 0.1\nmass = 2\nat = [0, 0, 1]\n"
       "turn_deg = [90, 0, 0]\n"},
      {"quaternion",
       "[body]\nmoments = [1, 2, 3]\n[motion]\nattitude = { quaternion = [1, 0, 0, 0] }\n"
       "spin = { rates_deg_per_s = [72, 0, -24] }\n"},
      {"rpm",
       "[body]\nmoments = [1, 2, 3]\n[motion]\nhold = \"pivot\"\nduration_min = 1\n"
       "spin.space_rpm = [0, 0, 300]\n"},
      {"momentum", "[body]\nmoments = [1, 2, 3]\n[motion]\nspin.momentum_body = [0, 1, 2]\n"},
      {"size as a list",
       "[body]\nmoments = [1, 2, 3]\n[video]\nsize = [640, 480]\nfps = \"30000/1001\"\n"},
      {"accuracy in radians", "[body]\nmoments = [1, 2, 3]\n[numerics]\naccuracy = 1e-6\n"},
      {"whole accuracy", "[body]\nmoments = [1, 2, 3]\n[numerics]\naccuracy = 1\nstep_ms = 2\n"},
  };
}

std::vector<BadSceneText> bad_scenes() {
  std::vector<BadSceneText> all;
  for (const std::vector<BadSceneText>& group : {unknown_keys(),
                                                 wrong_types(),
                                                 wrong_lengths(),
                                                 out_of_range(),
                                                 wrong_names(),
                                                 missing_and_exclusive_keys(),
                                                 wrong_video_and_accuracy()}) {
    all.insert(all.end(), group.begin(), group.end());
  }
  return all;
}

}  // namespace polhode
