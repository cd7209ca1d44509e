#version 330 core
// Shades solids and translucent shells. A software rasteriser runs both sides of every condition,
// so each kind of surface is a program of its own, with these constants: FINISH (0 plain, 1 wood,
// 2 brushed metal, 3 ceramic), TURNED (strokes of metal go round z, not along x), FLAT (colour and
// alpha as they are), VIVID (half of the light comes from everywhere), SOFT (of a flat mesh: alpha
// times the z of its normals, and their x of the colour of the mark), MARKED (a strip and a darker
// half), SIDED (the far side of a plane has the colour of the mark), SHELL (alpha under 1), LIGHT_GROUND (what is behind it is pale), FADING (fade under 1),
// DASHED (with gaps along z), FACES (those that are seen: 0 front, 1 back, 2 both), LIT_AT_CORNERS.

#include "surface.glsl"

out vec4 o_color;            // premultiplied

#if LIT_AT_CORNERS

noperspective in vec4 v_color;

void main() {
  o_color = v_color;
}

#else

noperspective in vec3 v_normal;
noperspective in vec4 v_along;
#if FINISH == 2
in vec3 v_to_eye;
#elif FINISH == 3
noperspective in vec2 v_window;
#endif
in vec3 v_mesh;
#if SOFT
in vec2 v_density;  // alpha, how much of the mark
#endif
#if SIDED
in float v_near;
#endif
#if FINISH == 2
in float v_lengthways;
#endif
flat in vec4 f_color;
flat in vec4 f_mark;
flat in vec4 f_alpha;
#if DASHED
flat in vec3 f_across;
#endif

// A strip along +x, and a cooler half x < 0: one turn looks different from half a turn.
vec3 painted() {
#if MARKED
  float least = 1e-9 * f_mark.w;  // never divide by nothing
  float soft_y = fwidth(v_mesh.y) + least;
  float soft_x = fwidth(v_mesh.x) + least;
  float front = clamp(v_mesh.x / soft_x + 0.5, 0.0, 1.0);
  float strip = clamp((f_mark.w - abs(v_mesh.y)) / soft_y + 0.5, 0.0, 1.0) * front;
  return mix(halved(f_color.rgb, front), f_mark.rgb, strip);
#elif SIDED
  float near = clamp(v_near / (fwidth(v_near) + 1e-9) + 0.5, 0.0, 1.0);
  return mix(f_mark.rgb, f_color.rgb, near);
#else
  return f_color.rgb;
#endif
}

// What wood and metal do to the colour: grain, brush strokes.
vec3 worn(vec3 color) {
#if FINISH == 1 || FINISH == 2
  float unit_length = max(f_alpha.w, 1e-9);
#endif
#if TURNED
  float radius = sqrt(dot(v_mesh.xy, v_mesh.xy)) / unit_length;
#endif
#if FINISH == 1
  return grained(color, v_mesh / unit_length);
#elif FINISH == 2
  // faces across x have strokes along y
#if TURNED
  float across = brushed(radius);
#else
  float across = brushed(v_mesh.y / unit_length) * v_lengthways;
#endif
  return stroked(color, across, brushed(v_mesh.z / unit_length));
#else
  return color;
#endif
}

// 1 over the length of what was unit at the corners and is a little shorter between them: a step of
// Newton's method from 1.
float stretch(vec3 v) {
  return 1.5 - 0.5 * dot(v, v);
}

void main() {
#if FLAT
#if SOFT
  vec3 color = mix(f_color.rgb, f_mark.rgb, v_density.y);
  o_color = vec4(color, 1.0) * (f_alpha.x * f_alpha.y * v_density.x);
#else
  o_color = vec4(f_color.rgb, 1.0) * (f_alpha.x * f_alpha.y);
#endif
#else
  float to_unit = stretch(v_normal);
#if FACES == 1
  to_unit = -to_unit;
#elif FACES == 2
  if (!gl_FrontFacing) to_unit = -to_unit;
#endif
  vec3 normal = to_unit * v_normal;
  vec4 parts = to_unit * v_along;
  float facing = abs(parts.w);
  vec3 color = worn(painted());
  vec3 light = light_on(parts.xy, normal.z, facing);
#if VIVID
  light = vivid(light);
#endif
  vec3 lit = color * color * light;

#if FINISH < 2
  lit = glossy(lit, f_color.a, parts.z);
#elif FINISH == 2
  vec3 to_eye = stretch(v_to_eye) * v_to_eye;
  vec3 mirrored = 2.0 * parts.w * normal - to_eye;
  lit = mirroring(color, lit, mirrored.z, parts.z);
#else
  lit = glazed(lit, to_unit * v_window, parts.z, facing);
#endif
#if DASHED
  vec3 shown = color;  // a drawn line, not a row of rings
#else
  vec3 shown = toned(lit);
#endif
#if SHELL
  o_color = shell(color, shown, f_alpha.x, facing);
#else
  o_color = vec4(shown, 1.0);
#endif
#if FADING
  o_color *= f_alpha.y;
#endif
#endif
#if DASHED
  // outlines are found of what is seen alone
  o_color *= dashed(v_mesh.z * f_alpha.z) * limb(dot(v_mesh, f_across));
#endif
}

#endif
