// Draws a contour over a slice.
#include "render/contourColour.glsl"

/* Textures */
layout(binding = 0) uniform sampler2D covers; // yellow, green, red, rim

/* Output: what is below counts for 1 − a */
layout(location = 0) out vec4 colour;

void main()
{
    colour = contourColour(texelFetch(covers, ivec2(gl_FragCoord.xy), 0));
}
