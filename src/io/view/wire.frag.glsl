#version 300 es
// Where a ray along -z meets a capsule, or the face where the cut plane goes through it.
precision highp float;
uniform float radius;
uniform float depth;         // z from depth to -depth becomes 0 to 1
uniform vec4 plane;
uniform bool cut;
uniform bool only_section;   // nothing but what is on the plane
uniform sampler2D map;
uniform vec3 none;           // colour where the field is zero
flat in vec3 first, second;
flat in vec2 shades;
in vec2 place;
layout(location = 0) out vec4 colour;  // and what it is: 1 surface, 0.5 cut face
layout(location = 1) out vec4 normal;  // and the distance from the axis over the radius

// Height of the front of the capsule; false where the ray misses it.
bool front(vec3 axis, out float z) {
  vec3 from = vec3(place, 0.0) - first;
  float axis2 = dot(axis, axis);
  float along = -axis.z, start = dot(axis, from), ahead = -from.z;
  float a = axis2 - along * along;
  float b = axis2 * ahead - start * along;
  float c = axis2 * dot(from, from) - start * start - radius * radius * axis2;
  float h = b * b - a * c;
  if (h < 0.0) return false;
  float t = a > 1e-9 * axis2 ? (-b - sqrt(h)) / a : 0.0;
  float at = start + t * along;
  if (a > 1e-9 * axis2 && at > 0.0 && at < axis2) {
    z = -t;
    return true;
  }
  bool upper = a > 1e-9 * axis2 ? at >= axis2 : axis.z > 0.0;
  vec3 centre = upper ? second : first;
  float r2 = radius * radius - dot(place - centre.xy, place - centre.xy);
  if (r2 < 0.0) return false;
  z = centre.z + sqrt(r2);
  return true;
}

vec3 shade(float share) {
  float at = mix(shades.x, shades.y, share);
  return min(shades.x, shades.y) < -0.5 ? none : texture(map, vec2(clamp(at, 0.0, 1.0), 0.5)).rgb;
}

void main() {
  vec3 axis = second - first;
  float z;
  if (!front(axis, z)) discard;
  vec3 point = vec3(place, z);
  bool face = cut && dot(plane.xyz, point) > plane.w;
  if (face) {
    if (plane.z <= 0.0) discard;  // all that follows on the ray is cut away too
    point.z = (plane.w - dot(plane.xy, place)) / plane.z;
  }
  if (only_section && !face) discard;
  float share = clamp(dot(point - first, axis) / dot(axis, axis), 0.0, 1.0);
  vec3 out_of_axis = point - first - share * axis;
  float distance = length(out_of_axis) / radius;
  if (face && distance > 1.0) discard;
  colour = vec4(shade(share), face ? 0.5 : 1.0);
  normal = vec4(face ? plane.xyz : out_of_axis / (radius * max(distance, 1e-6)), distance);
  normal.xyz = 0.5 * normal.xyz + 0.5;
  // Where strands overlap, a point of the plane belongs to the nearer axis.
  float behind = face ? 4e-3 * radius * distance : 0.0;
  gl_FragDepth = 0.5 - 0.5 * (point.z - behind) / depth;
}
