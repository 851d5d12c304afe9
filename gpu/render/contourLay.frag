// A contour over a slice: its line in the colours of its marks, and a dark rim.
#include "render/surfaceColour.glsl"

/* Textures */
layout(binding = 0) uniform sampler2D covers; // yellow, green, red, rim

/* Output: what is below counts for 1 − a */
layout(location = 0) out vec4 colour;

const float rimOpacity = 0.45;

void main()
{
    const vec4 cover = texelFetch(covers, ivec2(gl_FragCoord.xy), 0);
    const float inLine = max(max(cover.x, cover.y), cover.z);
    const float sum = max(cover.x + cover.y + cover.z, 1e-6);
    const vec3 own = (cover.x * marked(ownColour, 0) + cover.y * marked(ownColour, 1)
                         + cover.z * marked(ownColour, 2))
        / sum;
    const float below = (1.0 - inLine) * (1.0 - rimOpacity * cover.a);
    colour = vec4(own * inLine, 1.0 - below);
}
