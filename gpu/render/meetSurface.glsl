// The surface that is being refined among what a ray meets: it was rasterised before (SurfacePass),
// so each ray knows where it meets it, and what it sees there.

/* Textures */
layout(binding = 19) uniform sampler2D surfaceColours; // a: how much of the pixel; 0: none
layout(binding = 20) uniform sampler2D surfaceWays;    // t

/* Uniforms */
uniform float surfaceOpacity;
uniform float surfaceBehind; // how much of it shines through what hides it

float surfaceAt = nowhere;        // t
vec4 surfaceColour = vec4(0.0);   // opacity
float throughToSurface = 1.0;     // what lies before it lets so much through
bool surfaceMet = false;

void findSurface()
{
    const ivec2 pixel = ivec2(gl_FragCoord.xy);
    const vec4 colour = texelFetch(surfaceColours, pixel, 0);
    surfaceColour = vec4(colour.rgb, colour.a * surfaceOpacity);
    surfaceAt = colour.a > 0.0 ? texelFetch(surfaceWays, pixel, 0).r : nowhere;
}

/// Lays it behind what a ray has seen so far.
void meetSurface(inout vec3 seen, inout float through)
{
    throughToSurface = through;
    seen += through * surfaceColour.a * surfaceColour.rgb;
    through *= 1.0 - surfaceColour.a;
    surfaceMet = true;
#if SEEDS || BARRIERS || CHUNKS
    solidFrom = through < 0.5 ? min(solidFrom, surfaceAt) : solidFrom;
#endif
}

/// What of it shines through what hides it; where there is no before and behind it lies over all.
vec3 withSurface(vec3 seen)
{
#if MODE <= 1
    return mix(seen, surfaceColour.rgb, surfaceColour.a * surfaceBehind * (1.0 - throughToSurface));
#else
    return mix(seen, surfaceColour.rgb, surfaceColour.a);
#endif
}
