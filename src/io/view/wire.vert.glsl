#version 300 es
// One quad per edge of the wire: the outline of its capsule as seen along the view axis.
precision highp float;
precision highp sampler2D;
uniform sampler2D nodes;   // position, and the place of its colour in the map
uniform mat3 turn;         // world to view; the viewer looks along -z, in parallel rays
uniform vec2 pan;          // of the picture's middle, in view coordinates
uniform vec2 half_size;    // of the picture, in units of length
uniform vec2 jitter;       // of this sample, in clip coordinates
uniform float radius;
uniform vec4 plane;        // normal in view coordinates, offset; what is beyond is cut away
uniform bool cut;
flat out vec3 first, second;
flat out vec2 shades;
out vec2 place;

vec4 node(int i) { return texelFetch(nodes, ivec2(i & 1023, i >> 10), 0); }

void main() {
  vec4 a = node(gl_InstanceID), b = node(gl_InstanceID + 1);
  first = turn * a.xyz;
  second = turn * b.xyz;
  shades = vec2(a.w, b.w);
  vec2 along = second.xy - first.xy;
  float size = length(along);
  along = size > 1e-6 * radius ? along / size : vec2(1, 0);
  vec2 across = vec2(-along.y, along.x) * ((gl_VertexID & 1) == 0 ? -radius : radius);
  bool at_first = gl_VertexID < 2;
  place = (at_first ? first.xy - along * radius : second.xy + along * radius) + across;
  gl_Position = vec4((place - pan) / half_size + jitter, 0, 1);
  float nearest = min(dot(plane.xyz, first), dot(plane.xyz, second)) - radius;
  if (cut && nearest > plane.w) gl_Position = vec4(2, 2, 0, 1);  // outside: draws nothing
}
