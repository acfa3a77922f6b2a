#version 300 es
precision highp float;
uniform sampler2D picture;
in vec2 at;
out vec4 result;
void main() { result = texture(picture, at); }
