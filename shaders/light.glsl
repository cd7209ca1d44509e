// Shared by both stages. No pow, inversesqrt or atan: their low bits differ between processors, and
// they cost more than the rest together.

vec3 unit(vec3 v) {
  return v * (1.0 / sqrt(dot(v, v)));
}

// What falls on a surface, for squared colour: with a square root at the end that is close to sRGB
// and cheap. `along` are the parts of its normal along the key light and the fill light.
float light_on(vec2 along, float up) {
  float sky = 0.5 + 0.5 * up;
  return 0.21 + 0.19 * sky + 0.64 * max(along.x, 0.0) + 0.16 * max(along.y, 0.0);
}

// A translucent surface, premultiplied: denser where it is seen edge-on. `facing` is the cosine
// between its normal and the eye, `lit` its colour as an opaque one.
vec4 shell(vec3 color, vec3 lit, float alpha, float facing) {
  float edge = 1.0 - facing;
  float dense = min(1.0, alpha * (0.45 + 1.8 * edge * edge));
  return vec4(mix(color, lit, 0.35) * dense, dense);
}
