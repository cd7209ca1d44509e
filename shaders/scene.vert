#version 330 core
// Places a mesh in space and in the picture. Shells without a mark are lit here, at their corners:
// they bend gently, and several lie behind each other in a pixel. A software rasteriser fetches
// uniforms anew for each pixel, so what the other stage needs of them comes along with the corners.

layout(location = 0) in vec3 a_position;   // mesh coordinates
layout(location = 1) in vec3 a_normal;     // mesh coordinates, unit

uniform mat4 u_clip_from_world;
uniform mat4 u_world_from_mesh;
uniform mat3 u_normal_from_mesh;           // inverse transpose of the linear part
uniform vec3 u_eye;
uniform vec3 u_key_light;
uniform vec3 u_fill_light;
uniform vec3 u_color;                      // sRGB-encoded
uniform float u_alpha;                     // under 1: a shell
uniform float u_gloss;
uniform vec3 u_mark_color;                 // sRGB-encoded
uniform float u_mark_width;                // half-width of the strip, mesh units
uniform float u_grain;                     // unit of length of the finish, mesh units
uniform float u_fade;                      // of the whole thing, 1: there
uniform float u_dashes;                    // their number along z
uniform vec4 u_near_side;                  // a plane in mesh coordinates
uniform vec3 u_across;                     // unit, across z and the direction to the eye; mesh

#if LIT_AT_CORNERS
noperspective out vec4 v_color;    // premultiplied
#else
// unit at the corners; what bends gently needs no perspective between them
noperspective out vec3 v_normal;
// the normal's parts along key light, fill light, half-way from the first to the eye, and the eye
noperspective out vec4 v_along;
#if FINISH == 2
out vec3 v_to_eye;
#elif FINISH == 3
noperspective out vec2 v_window;   // the normal's parts across that halfway direction
#endif
out vec3 v_mesh;     // mesh coordinates, for the mark that turns with the body
#if SOFT
out vec2 v_density;
#endif
#if SIDED
out float v_near;    // under 0 on the far side
#endif
#if FINISH == 2
out float v_lengthways;  // 0 on faces across x
#endif
flat out vec4 f_color;  // and gloss
flat out vec4 f_mark;   // colour and half-width
flat out vec4 f_alpha;  // and fade, number of dashes, unit of the finish
#if DASHED
flat out vec3 f_across;
#endif
#endif

void main() {
  vec4 world = u_world_from_mesh * vec4(a_position, 1.0);
  gl_Position = u_clip_from_world * world;
  vec3 normal = unit(u_normal_from_mesh * a_normal);
  vec3 to_eye = unit(u_eye - world.xyz);
#if LIT_AT_CORNERS
  float facing = dot(normal, to_eye);
  if (facing < 0.0) normal = -normal;
#endif
  vec2 along = vec2(dot(normal, u_key_light), dot(normal, u_fill_light));
#if LIT_AT_CORNERS
  vec3 lit = toned(u_color * u_color * light_on(along, normal.z, abs(facing)));
  v_color = shell(u_color, lit, u_alpha, abs(facing)) * u_fade;
#else
  vec3 halfway = unit(u_key_light + to_eye);
  v_normal = normal;
  v_along = vec4(along, dot(normal, halfway), dot(normal, to_eye));
#if FINISH == 2
  v_to_eye = to_eye;
#elif FINISH == 3
  vec3 across = unit(cross(halfway, to_eye));
  v_window = vec2(dot(normal, across), dot(normal, cross(across, halfway)));
#endif
  v_mesh = a_position;
#if SOFT
  v_density = a_normal.zx;
#endif
#if SIDED
  v_near = dot(u_near_side, vec4(a_position, 1.0));
#endif
#if FINISH == 2
  v_lengthways = 1.0 - a_normal.x * a_normal.x;
#endif
  f_color = vec4(u_color, u_gloss);
  f_mark = vec4(u_mark_color, u_mark_width);
  f_alpha = vec4(u_alpha, u_fade, u_dashes, u_grain);
#if DASHED
  f_across = u_across;
#endif
#endif
}
