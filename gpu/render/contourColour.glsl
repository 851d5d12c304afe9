// The colours of a contour: its line in those of its marks, and a dark rim.
#include "render/surfaceColour.glsl"

const float rimOpacity = 0.45;

/// @param cover how much of the pixel is covered by the line of yellow, green and red, and by its
/// rim
/// @return what it adds; what is below counts by 1 − alpha
vec4 contourColour(vec4 cover)
{
    const float inLine = max(max(cover.x, cover.y), cover.z);
    const float sum = max(cover.x + cover.y + cover.z, 1e-6);
    const vec3 own = (cover.x * marked(ownColour, 0) + cover.y * marked(ownColour, 1)
                         + cover.z * marked(ownColour, 2))
        / sum;
    const float below = (1.0 - inLine) * (1.0 - rimOpacity * cover.a);
    return vec4(own * inLine, 1.0 - below);
}
