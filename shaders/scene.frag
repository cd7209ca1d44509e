#version 330 core
// Shades solids and translucent shells. No pow, inversesqrt or atan: their low bits differ between
// processors, and they cost more than the rest together.

in vec3 v_normal;
in vec3 v_world;
in vec3 v_mesh;

uniform vec3 u_eye;
uniform vec3 u_key_light;
uniform vec3 u_fill_light;
uniform vec3 u_color;        // sRGB-encoded
uniform float u_alpha;       // under 1: a shell
uniform float u_gloss;
uniform vec3 u_mark_color;   // sRGB-encoded
uniform int u_finish;        // 0 plain, 1 wood, 2 brushed metal, 3 ceramic
uniform bool u_flat;         // colour and alpha as they are
uniform bool u_soft;         // of a disc: less towards its rim
uniform float u_fade;        // of the whole thing, 1: there
uniform float u_mark_width;  // half-width of the strip, mesh units; 0 = no mark

out vec4 o_color;            // premultiplied

vec3 unit(vec3 v) {
  return v / sqrt(dot(v, v));
}

// A strip along +x and a darker half x < 0: one turn looks different from half a turn.
vec3 painted() {
  if (u_mark_width <= 0.0) return u_color;
  float least = 1e-9 * u_mark_width;  // never divide by nothing
  float soft_y = fwidth(v_mesh.y) + least;
  float soft_x = fwidth(v_mesh.x) + least;
  float front = clamp(v_mesh.x / soft_x + 0.5, 0.0, 1.0);
  float strip = clamp((u_mark_width - abs(v_mesh.y)) / soft_y + 0.5, 0.0, 1.0) * front;
  return mix(u_color * mix(0.80, 1.0, front), u_mark_color, strip);
}

// Bands of period 1 in x between 0 and 1, fading to their mean where they are finer than pixels.
float bands(float x) {
  float wave = abs(2.0 * fract(x) - 1.0);
  return mix(wave, 0.5, clamp(2.0 * fwidth(x), 0.0, 1.0));
}

// What wood and metal do to the colour: grain in rings about the axis, brush strokes.
vec3 worn(vec3 color) {
  float unit_length = max(u_mark_width, 1e-9);
  float radius = sqrt(dot(v_mesh.xy, v_mesh.xy)) / unit_length;
  if (u_finish == 1) {
    float grain = bands(0.8 * radius + 0.25 * v_mesh.z / unit_length);
    return color * (0.88 + 0.17 * grain * grain);
  }
  if (u_finish == 2) return color * (0.90 + 0.14 * bands(7.0 * radius));
  return color;
}

void main() {
  if (u_flat) {
    float inside = u_soft ? max(1.0 - dot(v_mesh.xy, v_mesh.xy), 0.0) : 1.0;
    o_color = vec4(u_color, 1.0) * (u_alpha * u_fade * inside * inside);
    return;
  }
  vec3 normal = unit(v_normal);
  if (!gl_FrontFacing) normal = -normal;
  vec3 to_eye = unit(u_eye - v_world);
  float facing = abs(dot(normal, to_eye));

  // light on squared colour, square root at the end: close to sRGB and cheap
  float key = max(dot(normal, u_key_light), 0.0);
  float fill = max(dot(normal, u_fill_light), 0.0);
  float sky = 0.5 + 0.5 * normal.z;
  float light = 0.17 + 0.13 * sky + 0.72 * key + 0.16 * fill;
  vec3 color = u_finish == 0 ? painted() : worn(painted());
  vec3 lit = color * color * light;

  // a highlight: cosine to the 32nd
  float cosine = max(dot(normal, unit(u_key_light + to_eye)), 0.0);
  float c2 = cosine * cosine;
  float c4 = c2 * c2;
  float c8 = c4 * c4;
  float c16 = c8 * c8;
  if (u_finish < 2) {
    lit += vec3(u_gloss * 0.55 * c16 * c16);
  } else {
    // metal mirrors a bright sky and a dark ground; glaze has a sharp light and a pale rim
    float rim = (1.0 - facing) * (1.0 - facing);
    if (u_finish == 2) {
      vec3 mirrored = 2.0 * dot(normal, to_eye) * normal - to_eye;
      float horizon = clamp(4.0 * mirrored.z + 0.5, 0.0, 1.0);
      lit = lit * 0.55 + color * color * (0.08 + 0.42 * horizon) + vec3(0.30 * c8 + 0.25 * c16 * c16);
    } else {
      float c64 = c16 * c16 * c16 * c16;
      lit += vec3(0.85 * c64 * c64 + 0.22 * rim * rim);
    }
  }
  vec3 shown = sqrt(min(lit, vec3(1.0)));

  // a shell is denser where it is seen edge-on
  float edge = 1.0 - facing;
  float alpha = u_alpha >= 1.0 ? 1.0 : min(1.0, u_alpha * (0.65 + 1.6 * edge * edge));
  if (u_alpha < 1.0) shown = mix(color, shown, 0.35);
  o_color = vec4(shown * alpha, alpha) * u_fade;
}
