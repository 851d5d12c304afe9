// Computes how much of a pixel a line of the contour covers, by its distance; the greatest value is
// kept.
#include "render/surfaceColour.glsl"

/* Uniforms */
uniform float halfWidth; // drawn pixels
uniform float rim;

/* Input */
layout(location = 0) flat in vec4 line; // drawn pixels
layout(location = 1) flat in vec3 marksFrom;
layout(location = 2) flat in vec3 marksTo;

/* Output */
layout(location = 0) out vec4 cover; // yellow, green, red, rim

void main()
{
    const vec2 along = line.zw - line.xy;
    const vec2 from = gl_FragCoord.xy - line.xy;
    const float part = clamp(dot(from, along) / max(dot(along, along), 1e-12), 0.0, 1.0);
    const float distance = length(from - along * part);
    const float inLine = clamp(halfWidth + 0.5 - distance, 0.0, 1.0);
    const int mark = markOf(mix(marksFrom, marksTo, part));
    cover = vec4(0.0);
    cover[mark] = inLine;
    cover.a = clamp(halfWidth + rim + 0.5 - distance, 0.0, 1.0);
}
