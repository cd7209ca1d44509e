// Shared by both stages. No pow, inversesqrt or atan: their low bits differ between processors, and
// they cost more than the rest together.

vec3 unit(vec3 v) {
  return v * (1.0 / sqrt(dot(v, v)));
}

// What falls on a surface, for squared colour: with a square root at the end that is close to sRGB
// and cheap. `along` are the parts of its normal along the key light and the fill light, `up` along
// the vertical, `facing` towards the eye. A warm key light, a cool sky, and what the floor throws
// back; limbs turn away from the lights of the studio on light ground, and catch one from behind on
// dark ground, so that they part from it.
vec3 light_on(vec2 along, float up, float facing) {
  float sky = 0.5 + 0.5 * up;
  float key = max(along.x, 0.0), fill = max(along.y, 0.0);
  float edge = (1.0 - facing) * (1.0 - facing);
#if LIGHT_GROUND
  vec3 round_about = mix(vec3(0.33, 0.295, 0.255), vec3(0.40, 0.42, 0.46), sky);
  return (round_about + key * vec3(0.86, 0.82, 0.76) + fill * vec3(0.09, 0.10, 0.12)) *
         (1.0 - 0.42 * edge);
#else
  vec3 round_about = mix(vec3(0.12, 0.12, 0.14), vec3(0.26, 0.28, 0.33), sky);
  return round_about + key * vec3(0.80, 0.77, 0.71) + fill * vec3(0.10, 0.12, 0.16) +
         edge * sky * vec3(0.20, 0.24, 0.30);
#endif
}

// Bright light wears off instead of being cut off: 1 at 1.6 and beyond.
vec3 toned(vec3 lit) {
  vec3 most = min(lit, vec3(1.6));
  return sqrt(most * (1.25 - 0.390625 * most));
}

// A soft edge from 0 to 1 where x goes from 0 to 1.
float eased(float x) {
  float t = clamp(x, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// A translucent surface, premultiplied: denser where it is seen edge-on. `facing` is the cosine
// between its normal and the eye, `lit` its colour as an opaque one.
vec4 shell(vec3 color, vec3 lit, float alpha, float facing) {
  float edge = 1.0 - facing;
  float dense = min(1.0, alpha * (0.45 + 1.8 * edge * edge));
  return vec4(mix(color, lit, 0.35) * dense, dense);
}
