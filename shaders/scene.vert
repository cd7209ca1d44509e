#version 330 core
// Places a mesh in space and in the picture. Shells without a mark are lit here, at their corners:
// they bend gently, and several lie behind each other in a pixel.

layout(location = 0) in vec3 a_position;   // mesh coordinates
layout(location = 1) in vec3 a_normal;     // mesh coordinates, unit

uniform mat4 u_clip_from_world;
uniform mat4 u_world_from_mesh;
uniform mat3 u_normal_from_mesh;           // inverse transpose of the linear part

#if LIT_AT_CORNERS
out vec4 v_color;    // premultiplied
#else
out vec3 v_normal;   // space, not unit
out vec3 v_to_eye;   // unit at the corners
out vec3 v_mesh;     // mesh coordinates, for the mark that turns with the body
#endif

void main() {
  vec4 world = u_world_from_mesh * vec4(a_position, 1.0);
  gl_Position = u_clip_from_world * world;
#if LIT_AT_CORNERS
  vec3 normal = unit(u_normal_from_mesh * a_normal);
  vec3 to_eye = unit(u_eye - world.xyz);
  float facing = dot(normal, to_eye);
  if (facing < 0.0) normal = -normal;
  vec3 lit = sqrt(min(u_color * u_color * light_on(normal), vec3(1.0)));
  v_color = shell(u_color, lit, abs(facing)) * u_fade;
#else
  v_to_eye = unit(u_eye - world.xyz);
  v_normal = u_normal_from_mesh * a_normal;
  v_mesh = a_position;
#endif
}
