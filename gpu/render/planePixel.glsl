// Finds where a pixel of the 3D view meets the cutting plane, and what of the plane's slice is seen
// there.
#include "render/contourColour.glsl"

/* Textures */
layout(binding = 23) uniform sampler2D covers; // of the contour: yellow, green, red, rim

/* Uniforms */
// maps pixels from the frame's middle to (mm to the right, mm down, 1) / depth
uniform mat3 mmFromPixel;
uniform vec2 middle;      // frame pixels
uniform vec3 centreIndex; // index
uniform vec3 perRight;    // index per mm
uniform vec3 perDown;
uniform vec2 halfSize;    // mm
uniform vec3 wayAlong; // orthographic: t as a function of (mm to the right, mm down, 1)
uniform float eyeDistance; // mm from the eye to the target's plane; 0: orthographic
uniform vec2 ahead;       // frame pixels: straight ahead of the eye
uniform float pixelMm; // mm per pixel in the target's plane
uniform float opacity;
uniform vec3 rimColour;
uniform float rimWidth;   // frame pixels
uniform int contourThere; // 0: there is none, and `covers` is one empty texel

/* Output */
layout(location = 1) out float way; // t

const float contourBias = 3.0; // frame pixels by which the line is drawn in front of its place

/// Position on the plane in mm, and 1 / depth, which is negative behind the eye.
vec3 onPlane(vec2 pixel)
{
    const vec3 at = mmFromPixel * vec3(pixel - middle, 1.0);
    return vec3(at.xy / (abs(at.z) < 1e-7 ? 1e-7 : at.z), at.z);
}

/// The index position at a pixel.
vec3 indexAt(vec2 pixel)
{
    const vec3 at = onPlane(pixel);
    return centreIndex + perRight * at.x + perDown * at.y;
}

/// @param slice colour of a slice there
/// @param isInside whether the place is inside the volume
vec4 planeColour(vec3 slice, bool isInside, vec2 pixel)
{
    const vec3 at = onPlane(pixel);
    // Distance to the border in frame pixels, by the differentials of the mapping.
    const vec2 perX = (mmFromPixel[0].xy - at.xy * mmFromPixel[0].z) / at.z;
    const vec2 perY = (mmFromPixel[1].xy - at.xy * mmFromPixel[1].z) / at.z;
    const vec2 room = (halfSize - abs(at.xy))
        / max(vec2(length(vec2(perX.x, perY.x)), length(vec2(perX.y, perY.y))), 1e-9);
    const float toBorder = min(room.x, room.y);
    const float all = at.z > 0.0 ? clamp(toBorder / pixelScale + 0.5, 0.0, 1.0) : 0.0;
    const float inner = min(all, clamp((toBorder - rimWidth) / pixelScale + 0.5, 0.0, 1.0));
    const float inRim = (all - inner) * opacity;
    const float inSlice = isInside ? inner * opacity : 0.0;

    const vec4 line
        = contourColour(texelFetch(covers, ivec2(gl_FragCoord.xy) * contourThere, 0)) * all;
    const float below = 1.0 - line.a;
    const float cover = line.a + below * (inSlice + inRim);
    const vec3 sum = line.rgb + below * (inSlice * slice + inRim * rimColour);

    const vec2 slope = (pixel - ahead) * pixelMm / max(eyeDistance, 1e-6);
    way = eyeDistance > 0.0 ? eyeDistance / at.z * length(vec3(slope, 1.0))
                            : dot(wayAlong, vec3(at.xy, 1.0));
    way -= line.a > 0.0 ? contourBias * pixelMm / at.z : 0.0;
    return vec4(sum / max(cover, 1e-6), cover);
}
