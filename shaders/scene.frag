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

void main() {
  vec3 normal = unit(v_normal);
  if (!gl_FrontFacing) normal = -normal;
  vec3 to_eye = unit(u_eye - v_world);
  float facing = abs(dot(normal, to_eye));

  // light on squared colour, square root at the end: close to sRGB and cheap
  float key = max(dot(normal, u_key_light), 0.0);
  float fill = max(dot(normal, u_fill_light), 0.0);
  float sky = 0.5 + 0.5 * normal.z;
  float light = 0.17 + 0.13 * sky + 0.72 * key + 0.16 * fill;
  vec3 color = painted();
  vec3 lit = color * color * light;

  // a highlight: cosine to the 32nd
  float cosine = max(dot(normal, unit(u_key_light + to_eye)), 0.0);
  float c2 = cosine * cosine;
  float c4 = c2 * c2;
  float c8 = c4 * c4;
  float c16 = c8 * c8;
  lit += vec3(u_gloss * 0.55 * c16 * c16);
  vec3 shown = sqrt(min(lit, vec3(1.0)));

  // a shell is denser where it is seen edge-on
  float edge = 1.0 - facing;
  float alpha = u_alpha >= 1.0 ? 1.0 : min(1.0, u_alpha * (0.65 + 1.6 * edge * edge));
  if (u_alpha < 1.0) shown = mix(color, shown, 0.35);
  o_color = vec4(shown * alpha, alpha);
}
