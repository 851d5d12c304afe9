// Sheets among the matter along a ray: the surface that is being refined, and the cutting plane.
// They were drawn before (SurfacePass, PlanePass), so each ray knows where it meets them and which
// colour it sees there. They may intersect each other, so the nearer one is determined for each
// pixel.

/* Textures */
// alpha: how much of the pixel it covers; 0: none
layout(binding = 19) uniform sampler2D surfaceColours;
layout(binding = 20) uniform sampler2D surfaceWays;    // t
layout(binding = 21) uniform sampler2D planeColours;
layout(binding = 22) uniform sampler2D planeWays;

/* Uniforms */
uniform int surfaceThere; // 0: there is none, and its textures are one empty texel
uniform int planeThere;
uniform float surfaceOpacity;
uniform float surfaceBehind; // how much of it shines through what hides it
uniform float planeBehind;

// mm: up to this far in front of the plane the surface counts as not in front of it
const float sheetTie = 0.05;

struct Sheet {
    vec4 colour; // opacity
    float at;    // t; nowhere: none
    float behind;
    float before; // how much of it no sheet hides
    float shining; // how much of it shines through what hides it
};
Sheet nearSheet = Sheet(vec4(0.0), nowhere, 0.0, 1.0, 0.0);
Sheet farSheet = Sheet(vec4(0.0), nowhere, 0.0, 1.0, 0.0);
int sheetsMet = 0;
float nextSheetAt = nowhere; // t of the next sheet
#if CONTEXT == 1
float surfaceMetAt = nowhere; // t
#endif

void findSheets()
{
    const ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 surface = texelFetch(surfaceColours, pixel * surfaceThere, 0);
    const vec4 plane = texelFetch(planeColours, pixel * planeThere, 0);
    const float surfaceAt
        = surface.a > 0.0 ? texelFetch(surfaceWays, pixel * surfaceThere, 0).r : nowhere;
    const float planeAt = plane.a > 0.0 ? texelFetch(planeWays, pixel * planeThere, 0).r : nowhere;
    surface.a *= surfaceOpacity;
#if CONTEXT == 1
    surfaceMetAt = surfaceAt;
#endif
    const bool planeFirst = planeAt <= surfaceAt + sheetTie;
    nearSheet.colour = planeFirst ? plane : surface;
    nearSheet.at = planeFirst ? planeAt : surfaceAt;
    nearSheet.behind = planeFirst ? planeBehind : surfaceBehind;
    farSheet.colour = planeFirst ? surface : plane;
    farSheet.at = planeFirst ? surfaceAt : planeAt;
    farSheet.behind = planeFirst ? surfaceBehind : planeBehind;
    // The surface shines through matter, but not through a plane, which must stay readable.
    farSheet.before = planeFirst ? 1.0 - plane.a : 1.0;
    nextSheetAt = nearSheet.at;
}

/// How much of the pixel the cutting plane covers, and where it is met (t).
vec2 planeHere()
{
    const ivec2 pixel = ivec2(gl_FragCoord.xy) * planeThere;
    const float cover = texelFetch(planeColours, pixel, 0).a;
    return vec2(cover, cover > 0.0 ? texelFetch(planeWays, pixel, 0).r : nowhere);
}

/// The t behind which nothing is seen; nowhere if there is no opaque sheet.
float opaqueSheetAt()
{
    return nearSheet.colour.a >= 1.0 ? nearSheet.at
        : farSheet.colour.a >= 1.0   ? farSheet.at
                                     : nowhere;
}

/// Composites the next sheet behind what the ray has seen so far.
void meetSheet(inout vec3 seen, inout float through)
{
    const bool isNear = sheetsMet == 0;
    const vec4 own = isNear ? nearSheet.colour : farSheet.colour;
    const float hidden = max((isNear ? 1.0 : farSheet.before) - through, 0.0);
    nearSheet.shining = isNear ? nearSheet.behind * hidden : nearSheet.shining;
    farSheet.shining = isNear ? 0.0 : farSheet.behind * hidden;
    seen += through * own.a * own.rgb;
    through *= 1.0 - own.a;
#if OVERLAID
    solidFrom = through < 0.5 ? min(solidFrom, nextSheetAt) : solidFrom;
#endif
    ++sheetsMet;
    nextSheetAt = isNear ? farSheet.at : nowhere;
}

/// Composites the sheets up to a t.
void meetSheets(float t, inout vec3 seen, inout float through)
{
    for (int i = 0; i < 2; ++i) {
        if (sheetsMet < 2 && nextSheetAt <= t)
            meetSheet(seen, through);
    }
}

/// Adds what shines through what hides them. In modes without an order of depth the sheets are
/// drawn over everything.
vec3 withSheets(vec3 seen)
{
#if MODE <= 1
    seen = mix(seen, farSheet.colour.rgb, farSheet.colour.a * farSheet.shining);
    return mix(seen, nearSheet.colour.rgb, nearSheet.colour.a * nearSheet.shining);
#else
    seen = mix(seen, farSheet.colour.rgb, farSheet.colour.a);
    return mix(seen, nearSheet.colour.rgb, nearSheet.colour.a);
#endif
}
