#version 300 es
// Lights what is seen: surfaces by a lamp and by how much of the surroundings they see (ambient
// occlusion, from the depths around the pixel), cut faces plainly; and draws the cavity.
precision highp float;
precision highp sampler2D;
uniform sampler2D colours, normals, depths;
uniform vec2 pan, half_size, jitter;
uniform float depth, radius, cavity;  // cavity: its longest semi-axis
uniform mat3 wall;          // the cavity: p.wall p = 1
uniform float pixel;        // its size, in units of length
uniform float line;         // width of the cavity's lines in pixels
uniform float sample_turn;  // of the pattern of occlusion samples
uniform vec4 plane;
uniform bool cut, outline;
uniform vec3 ink;           // colour of the cavity's lines
in vec2 at;
out vec4 result;

const int samples = 14;

float height(vec2 where) { return depth * (1.0 - 2.0 * texture(depths, where).r); }

float openness(vec3 point, vec3 normal) {
  float place = dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715));
  float turn = sample_turn + 6.2832 * fract(52.9829189 * fract(place));
  float reach = 5.0 * radius, hidden = 0.0;
  for (int k = 0; k < samples; ++k) {
    float share = (float(k) + 0.5) / float(samples);
    float angle = turn + 2.39996 * float(k);
    vec2 offset = max(reach * share * share, 1.5 * pixel) * vec2(cos(angle), sin(angle));
    vec3 towards = vec3(offset, height(at + 0.5 * offset / half_size) - point.z);
    float size2 = dot(towards, towards);
    float near = max(0.0, 1.0 - size2 / (reach * reach));
    hidden += near * max(0.0, dot(towards, normal) - 0.05 * radius) /
              sqrt(size2 + 0.01 * radius * radius);
  }
  return clamp(1.0 - 2.1 * hidden / float(samples), 0.0, 1.0);
}

// How much nearer the surroundings of the pixel are: the rim of a strand in front.
float rim(vec3 point) {
  vec2 step = 1.3 * pixel * 0.5 / half_size;
  float near = max(max(height(at + vec2(step.x, 0)), height(at - vec2(step.x, 0))),
                   max(height(at + vec2(0, step.y)), height(at - vec2(0, step.y))));
  return smoothstep(0.5 * radius, 2.0 * radius, near - point.z) *
         smoothstep(1.5, 5.0, radius / pixel);
}

vec3 lit(vec3 colour, vec3 normal, vec3 point) {
  vec3 lamp = normalize(vec3(-0.45, 0.6, 0.8));
  float open = openness(point, normal);
  float diffuse = max(dot(normal, lamp), 0.0);
  float gloss = pow(max(dot(reflect(-lamp, normal), vec3(0, 0, 1)), 0.0), 24.0);
  float deep = clamp(0.5 - 0.5 * point.z / cavity, 0.0, 1.0);
  vec3 light = colour * (0.42 + 0.68 * diffuse) + 0.12 * gloss;
  return light * mix(0.18, 1.0, open) * mix(1.0, 0.72, deep) * (1.0 - 0.55 * rim(point));
}

float stroke(float off, float width) {
  return 1.0 - smoothstep(0.5 * width - 0.5, 0.5 * width + 0.5, abs(off));
}

// The wall is p.wall p = 1. A line of sight through a place meets it at two depths; the square of
// half their distance over that at the middle of a sphere: 1 where the wall faces the viewer, 0 on
// its outline.
float facing_squared(vec2 place) {
  float across = dot(wall[2].xy, place);
  float flat_part = dot(place, mat2(wall) * place);
  return 1.0 - flat_part + across * across / wall[2].z;
}
vec2 facing_squared_slope(vec2 place) {
  return 2.0 * (wall[2].xy * dot(wall[2].xy, place) / wall[2].z - mat2(wall) * place);
}

void main() {
  vec4 seen = texture(colours, at);
  vec2 place = (2.0 * at - 1.0 - jitter) * half_size + pan;
  vec3 point = vec3(place, height(at));
  vec4 normal = texture(normals, at);
  bool background = seen.a < 0.25;
  result = vec4(0);
  if (!background && seen.a < 0.75) {
    float border = smoothstep(0.86, 0.93, normal.w) * smoothstep(2.5, 6.0, radius / pixel);
    result = vec4(seen.rgb * (1.0 - 0.6 * border), 1);
  } else if (!background) {
    result = vec4(lit(seen.rgb, normalize(2.0 * normal.xyz - 1.0), point), 1);
  }
  if (!outline) return;
  float cover = 0.0;
  if (background) {
    float inside = facing_squared(place);
    cover = inside > 0.0 ? 0.03 + 0.2 * pow(1.0 - sqrt(inside), 3.0) : 0.0;
    vec2 slope = facing_squared_slope(place);
    cover = max(cover, 0.6 * stroke(inside / (pixel * length(slope) + 1e-12), line));
  }
  if (cut && abs(plane.z) > 1e-3) {
    float z = (plane.w - dot(plane.xy, place)) / plane.z;
    vec3 rise = 2.0 * wall * vec3(place, z);
    float steep = length(rise.xy - plane.xy * rise.z / plane.z);
    float off = (dot(vec3(place, z), rise) / 2.0 - 1.0) / (pixel * steep + 1e-12);
    if (background || z > point.z - 0.05 * radius) cover = max(cover, 0.8 * stroke(off, line));
  }
  result = mix(result, vec4(ink, 1), cover);
}
