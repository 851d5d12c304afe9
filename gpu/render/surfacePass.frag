// Draws the surface that is being refined: its colour, and where the ray of the pixel meets it.
// WIRES: only the edges; GREYS: values of the volume; HIDES: planes hide parts of it. Variants that
// discard nothing are depth-tested before they are shaded.
#include "render/parts/light.glsl"
#include "render/surfaceColour.glsl"

/* Textures */
layout(binding = 0) uniform sampler3D intensity; // code / 65535

/* Uniforms */
uniform vec3 viewForward; // world, unit
uniform vec3 viewTarget;  // world
uniform vec3 sight; // world, unit: direction of orthographic rays
uniform vec3 eyeToTarget; // world
uniform float wayPerDepth; // t per depth, for orthographic rays
uniform bool orthographic;
uniform float wireHalf;    // drawn pixels
#if HIDES
uniform vec4 hiddenBeyond[10]; // world: hidden where dot(xyz, place) > w
uniform int hiddenCount; // six planes of a box, three clip planes, and its own
#endif
uniform mat4 worldToTexture;
uniform vec2 window; // grey = code / 65535 · x + y

/* Input */
layout(location = 0) in vec3 fromTarget; // world
layout(location = 1) in vec3 outwards;
layout(location = 2) in vec4 placeMarks;

/* Output */
layout(location = 0) out vec4 colour;
layout(location = 1) out float way;

const float insideShade = 0.62;
const float greyLight = 0.35; // grey values must be readable, so they are shaded less

void main()
{
    const vec3 place = fromTarget + viewTarget;
    float cover = 1.0;
#if WIRES
    // Distance from the nearest edge of the face, in pixels.
    const float toRim
        = placeMarks.w / max(length(vec2(dFdx(placeMarks.w), dFdy(placeMarks.w))), 1e-6);
    cover = clamp(wireHalf + 0.5 - toRim, 0.0, 1.0);
    if (cover < 0.02)
        discard;
#endif
#if HIDES
    bool hidden = false;
    for (int i = 0; i < hiddenCount; ++i)
        hidden = hidden || dot(hiddenBeyond[i].xyz, place) > hiddenBeyond[i].w;
    if (hidden)
        discard;
#endif

    const vec3 fromEye = fromTarget + eyeToTarget;
    way = orthographic ? dot(fromTarget, viewForward) * wayPerDepth : length(fromEye);
    const vec3 toViewer = orthographic ? -sight : normalize(-fromEye);

    // Rows run downwards, so what is counter-clockwise seen from outside is clockwise in the
    // picture.
    const bool isInside = gl_FrontFacing;
    vec3 normal = normalize(outwards + 1e-6 * toViewer) * (isInside ? -1.0 : 1.0);
    // At the silhouette an interpolated normal may face away.
    const float away = min(dot(normal, toViewer), 0.0);
    normal = normalize(normal - (away - 0.02) * toViewer);

    vec4 light = lightOn(normal, toViewer, 1.0, isInside ? 0.0 : 0.15);
    vec3 own = ownColour;
#if GREYS
    const vec3 at = (worldToTexture * vec4(place, 1.0)).xyz;
    own = vec3(clamp(texture(intensity, at).r * window.x + window.y, 0.0, 1.0));
    light = vec4(mix(vec3(1.0), light.rgb, greyLight), 0.0);
#endif
    const vec3 albedo = marked(own, markOf(placeMarks.xyz));
    colour = vec4(lit(albedo, light) * (isInside ? insideShade : 1.0), cover);
}
