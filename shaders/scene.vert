#version 330 core
// Places a mesh in space and in the picture.

layout(location = 0) in vec3 a_position;   // mesh coordinates
layout(location = 1) in vec3 a_normal;     // mesh coordinates, unit

uniform mat4 u_clip_from_world;
uniform mat4 u_world_from_mesh;
uniform mat3 u_normal_from_mesh;           // inverse transpose of the linear part

out vec3 v_normal;   // space, not unit
out vec3 v_world;    // the drawing frame
out vec3 v_mesh;     // mesh coordinates, for the mark that turns with the body

void main() {
  vec4 world = u_world_from_mesh * vec4(a_position, 1.0);
  v_world = world.xyz;
  v_normal = u_normal_from_mesh * a_normal;
  v_mesh = a_position;
  gl_Position = u_clip_from_world * world;
}
