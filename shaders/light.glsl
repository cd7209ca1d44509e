// Shared by both stages. No pow, inversesqrt or atan: their low bits differ between processors, and
// they cost more than the rest together.

uniform vec3 u_eye;
uniform vec3 u_key_light;
uniform vec3 u_fill_light;
uniform vec3 u_color;        // sRGB-encoded
uniform float u_alpha;       // under 1: a shell
uniform float u_fade;        // of the whole thing, 1: there

vec3 unit(vec3 v) {
  return v * (1.0 / sqrt(dot(v, v)));
}

// What falls on a surface, for squared colour: with a square root at the end that is close to sRGB
// and cheap.
float light_on(vec3 normal) {
  float key = max(dot(normal, u_key_light), 0.0);
  float fill = max(dot(normal, u_fill_light), 0.0);
  float sky = 0.5 + 0.5 * normal.z;
  return 0.17 + 0.13 * sky + 0.72 * key + 0.16 * fill;
}

// A translucent surface, premultiplied: denser where it is seen edge-on. `facing` is the cosine
// between its normal and the eye, `lit` its colour as an opaque one.
vec4 shell(vec3 color, vec3 lit, float facing) {
  float edge = 1.0 - facing;
  float alpha = min(1.0, u_alpha * (0.65 + 1.6 * edge * edge));
  return vec4(mix(color, lit, 0.35) * alpha, alpha);
}
