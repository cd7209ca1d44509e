// What surfaces make of the light that falls on them. Films (scene.frag) and pages
// (src/html/pages/turn.js) shade alike by these; the numbers of the light itself are in light.glsl.

// The half x < 0 of a marked body is cooler (`front` is 0 there). It is not darker: that would look
// like shade.
vec3 halved(vec3 color, float front) {
  return color * mix(vec3(0.54, 0.71, 0.90), vec3(1.0), front);
}

// Brush strokes of period 1 in x between -1 and 1: parabolas, which lack the high harmonics of a
// triangle. They are full where a period has eight pixels and gone where it has four.
float strokes(float x) {
  float wave = 2.0 * fract(x) - 1.0;
  wave *= 4.0 * (1.0 - abs(wave));
  return wave * clamp(2.0 - 8.0 * fwidth(x), 0.0, 1.0);
}
// Strokes of three widths, so that some are seen at any size.
float brushed(float x) {
  return strokes(0.83 * x) + strokes(2.11 * x + 0.3) + strokes(5.3 * x + 0.7);
}

// A thin line in each period 1 of x, 0 to 1, some fainter than others. It fades to its mean where
// periods are finer than pixels.
float fine_lines(float x) {
  float line = clamp(1.0 - 5.0 * abs(fract(x) - 0.5), 0.0, 1.0);
  float strength = 0.6 + 0.4 * sin(2.4 * floor(x));
  return strength * mix(line, 0.2, clamp(3.0 * fwidth(x) - 0.5, 0.0, 1.0));
}

// Wood: the body is turned from a board, whose rings of years go round an axis along y beside it.
// Rings about the body's own axis would look like ridges of a lathe, broad ones like folds. at: in
// units of the finish.
vec3 grained(vec3 color, vec3 at) {
  vec2 from_core = at.xz + vec2(9.0, 5.0) + 0.25 * sin(0.31 * at.y + vec2(0.0, 1.3));
  float years = 2.6 * length(from_core);
  // they are not equally wide
  years += 0.7 * sin(0.45 * years) + 0.3 * sin(1.3 * years + 1.0);
  return color * mix(vec3(1.02), vec3(0.88, 0.84, 0.78), fine_lines(years));
}
// Metal: each stroke, across and along, brightens and darkens a little.
vec3 stroked(vec3 color, float across, float along) {
  return color * (0.97 + 0.018 * (across + along));
}

// Half of the light on vivid things comes from everywhere.
vec3 vivid(vec3 light) {
#if LIGHT_GROUND
  return 0.62 + 0.5 * light;
#else
  return 0.54 + 0.48 * light;
#endif
}

// The key light is a round lamp behind a cloth. `glance`: the normal's part half-way between it and
// the eye.
vec3 glossy(vec3 lit, float gloss, float glance) {
  return lit + vec3(gloss * 0.62 * eased(12.0 * glance - 11.0));
}
// Metal mirrors a bright sky and a dark ground. `up`: of the mirrored line of sight.
vec3 mirroring(vec3 color, vec3 lit, float up, float glance) {
  float horizon = clamp(4.0 * up + 0.5, 0.0, 1.0);
  float c2 = max(glance, 0.0) * max(glance, 0.0);
  float c8 = c2 * c2 * c2 * c2;
  return lit * 0.55 + color * color * (0.08 + 0.42 * horizon) +
         vec3(0.30 * c8 + 0.25 * c8 * c8 * c8 * c8);
}
// Glaze mirrors a square lamp, a strip of light at the other side, and more at its limbs. `window`:
// the normal's parts across the direction of `glance`.
vec3 glazed(vec3 lit, vec2 window, float glance, float facing) {
  float lamp = eased(9.0 - 60.0 * abs(window.x)) * eased(9.0 - 60.0 * abs(window.y));
  float rim = (1.0 - facing) * (1.0 - facing);
  return lit + vec3(0.9 * lamp * step(0.0, glance) + 0.22 * rim * rim);
}

// How much of a pixel a round line covers, which falls from 1 to 0 within a pixel of its limb. Only
// pixels whose middle it covers are drawn: thin lines, which would lose too much, fall to a half.
// across: how far it is from the middle of the line, in its radius.
float limb(float across) {
  vec2 slope = vec2(dFdx(across), dFdy(across));
  float radius = 1.0 / (length(slope) + 1e-9);  // pixels
  return clamp((1.0 - abs(across)) * radius + 0.5 * clamp(2.0 - radius, 0.0, 1.0), 0.0, 1.0);
}

// A dash and a gap of the same length, with edges as wide as a pixel.
float dashed(float along) {
  return clamp((0.25 - abs(fract(along) - 0.25)) / fwidth(along) + 0.5, 0.0, 1.0);
}
