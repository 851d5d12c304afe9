// Draws one pixel of a slice view. LABELED, CARVED, BARRIERS, WARNED, CUT_PREVIEW, CHUNKS, PIECES:
// whether there is anything of this kind to draw. LABEL_PLANES: how many label planes there are (1 … 4).
// AT_TOLERANCE: one segment is drawn as it would be at a
// tolerance. CUBIC: cubic interpolation of the grey values; NEAREST: none of them. PLANE: draws the
// cutting plane in the 3D view. SLAB: the grey values are those of a slab about the slice.

/* Textures */
layout(binding = 0) uniform sampler3D intensity; // code / 65535
layout(binding = 1) uniform sampler3D radiation; // ≥ 0.5: carved away
layout(binding = 3) uniform usampler3D labels;   // of plane 0
#if LABEL_PLANES > 1
layout(binding = 30) uniform usampler3D labels1; // of the next plane
#endif
#if LABEL_PLANES > 2
layout(binding = 31) uniform usampler3D labels2;
#endif
#if LABEL_PLANES > 3
layout(binding = 32) uniform usampler3D labels3;
#endif
layout(binding = 7) uniform sampler2D palette;   // rgb, opacity (0: not shown)
#if BARRIERS || WARNED || AT_TOLERANCE || CUT_PREVIEW
#include "kernels/labels/memberWords.glsl"
#endif
#if AT_TOLERANCE
#include "kernels/spread/toleranceLabel.glsl"
#endif
#if CUT_PREVIEW
#include "render/parts/cutPreview.glsl"
#endif
#if CUBIC
#include "render/cubic.glsl"
#endif
#include "render/parts/colourMap.glsl"

#if CHUNKS
layout(binding = 24) uniform usampler3D chunkLeaves; // leaf + 1 by cell of their box
layout(binding = 25) uniform sampler2D chunkColours; // by leaf, alpha 0: none; above it the rims
uniform ivec3 chunkOrigin; // index: the box, up to one before the second
uniform ivec3 chunkEnd;
uniform ivec3 chunkCell; // voxels
uniform ivec2 chunkCodes; // only voxels with these are drawn; all, if no code comes to the second
uniform float chunkOpacity;
#endif

#if PIECES
const int mostPieces = 64; // gpu/render/SlicePass.cpp
layout(binding = 9) uniform sampler3D footprints; // ≥ 0.5: belongs to the piece
uniform int pieceCount;
uniform vec4 pieceLow[mostPieces]; // index, xyz: the box that a piece fills
uniform vec4 pieceHigh[mostPieces];
uniform vec4 pieceShift[mostPieces]; // texel of footprints = index + this + 0.5
#endif

/* Uniforms */
uniform vec3 base; // index: position of pixel (0, 0)
uniform vec3 perX;   // index per pixel
uniform vec3 perY;
uniform float pixelScale;
uniform vec2 pixelJitter; // frame pixels
uniform vec2 window; // grey = code / 65535 · x + y
uniform bool inverted;
uniform bool showCarved;
uniform bool carvedAsHole;
uniform float fillOpacity;
uniform float outlineWidth; // pixels
#if LABEL_PLANES > 1
uniform uint growthPlace; // which of these planes is the one whose growth is shown
#else
const uint growthPlace = 0u;
#endif

/* Output */
layout(location = 0) out vec4 colour;

const vec3 carvedColour = vec3(0.94, 0.55, 0.29);
const float carvedWidth = 1.5; // pixels
const vec3 barrierColour = vec3(0.93, 0.25, 0.36);
const float barrierWidth = 1.2; // pixels
const float cutPreviewWidth = 1.5; // pixels
const float chunkWidth = 0.8; // pixels
const float chunkRimWidth = 1.8; // pixels
const vec3 pieceColour = vec3(0.29, 0.64, 1.0);
const float pieceWidth = 1.5; // pixels
#if PLANE
uniform uint maskLabel; // the segment that is being refined; 0: none
const vec3 maskColour = vec3(0.90, 0.24, 0.18);
#endif

#if SLAB
uniform vec3 slabFirst; // index: from the slice to the first sample
uniform vec3 slabStep;  // index: from a sample to the next
uniform int slabCount;
uniform int slabMode; // SlabMode: 1 the greatest value, 2 the least, 3 the mean
#endif

#if PLANE
#include "render/planePixel.glsl"
#else
/// The index position at a pixel (pixel centres at + 0.5).
vec3 indexAt(vec2 pixel)
{
    return base + perX * pixel.x + perY * pixel.y;
}
#endif

ivec3 nearestVoxel(vec3 index)
{
    return clamp(ivec3(floor(index + 0.5)), ivec3(0), textureSize(labels, 0) - 1);
}

#if BARRIERS
bool isBarrier(ivec3 voxel)
{
    return wordAt(voxel) == barrierWord;
}
#endif

/// What a plane shows. @param place of the plane among those that there are
uint labelIn(usampler3D plane, uint place, ivec3 voxel)
{
    const uint held = texelFetch(plane, voxel, 0).r;
#if AT_TOLERANCE
    return place == growthPlace ? labelAtTolerance(held, voxel) : held;
#else
    return held;
#endif
}

uint labelAt(ivec3 voxel)
{
    return labelIn(labels, 0u, voxel);
}

/// The colour of a label in a plane, which may warn of what a growth reached late.
vec4 entryOf(uint label, uint place, ivec3 voxel)
{
    vec4 entry = texelFetch(palette, ivec2(int(label), 0), 0);
#if WARNED
    if (place == growthPlace && warns(voxel))
        entry.rgb = texelFetch(palette, ivec2(0), 0).rgb;
#endif
    return entry;
}

#if CHUNKS
int chunkLeafAt(vec3 index)
{
    const ivec3 there = nearestVoxel(index);
    const ivec3 cell = max(there - chunkOrigin, ivec3(0)) / chunkCell;
    bool has = all(greaterThanEqual(there, chunkOrigin)) && all(lessThan(there, chunkEnd));
    if (has && chunkCodes.y < 65536) {
        const int code = int(texelFetch(intensity, there, 0).r * 65535.0 + 0.5);
        has = code >= chunkCodes.x && code <= chunkCodes.y;
    }
    return has ? int(texelFetch(chunkLeaves, cell, 0).r) : 0;
}

vec4 chunkAt(vec3 index)
{
    return texelFetch(chunkColours, ivec2(chunkLeafAt(index), 0), 0);
}

vec4 chunkRimAt(vec3 index)
{
    return texelFetch(chunkColours, ivec2(chunkLeafAt(index), 1), 0);
}
#endif

#if PIECES
float footprintAt(int piece, vec3 index)
{
    const vec3 low = pieceLow[piece].xyz;
    const vec3 high = pieceHigh[piece].xyz;
    const bool within = all(greaterThanEqual(index, low - 0.5)) && all(lessThan(index, high - 0.5));
    const vec3 texel = clamp(index, low, high - 1.0) + pieceShift[piece].xyz + 0.5;
    return within ? textureLod(footprints, texel / vec3(textureSize(footprints, 0)), 0.0).r : 0.0;
}
#endif

/// The value (code / 65535) at a position.
float valueAt(vec3 index)
{
#if NEAREST
    // Fetched, because filtering hardware rounds places as well as weights.
    const ivec3 last = textureSize(intensity, 0) - 1;
    return texelFetch(intensity, clamp(ivec3(floor(index + 0.5)), ivec3(0), last), 0).r;
#elif CUBIC
    return cubicAt(intensity, index);
#else
    return textureLod(intensity, (index + 0.5) / vec3(textureSize(intensity, 0)), 0.0).r;
#endif
}

#if SLAB
/// The slab's value (code / 65535) about a position in the slice; negative where no sample counts.
float slabAt(vec3 index)
{
    const vec3 size = vec3(textureSize(intensity, 0));
    float greatest = -1.0;
    float least = 2.0;
    float sum = 0.0;
    int count = 0;
    for (int k = 0; k < slabCount; ++k) {
        const vec3 there = index + slabFirst + slabStep * float(k);
        bool counts
            = all(greaterThanEqual(there, vec3(-0.5))) && all(lessThan(there, size - 0.5));
#if CARVED
        const float covered = textureLod(radiation, (there + 0.5) / size, 0.0).r;
        counts = counts && !(carvedAsHole && covered >= 0.5);
#endif
        if (!counts)
            continue;
        const float value = valueAt(there);
        greatest = max(greatest, value);
        least = min(least, value);
        sum += value;
        ++count;
    }
    if (count == 0)
        return -1.0;
    return slabMode == 1 ? greatest : slabMode == 2 ? least : sum / float(count);
}
#endif

vec2 around(int i)
{
    const float angle = 0.785398163 * float(i);
    return vec2(cos(angle), sin(angle));
}

#if LABELED && LABEL_PLANES > 1
/// What a further plane shows at a pixel: a fill or, if the pixel is at a border, a line.
struct FurtherSegment {
    vec4 own; // colour, opacity
    uint label;
    bool edge;
};

FurtherSegment furtherSegment(usampler3D plane, uint place, vec3 index, vec2 pixel)
{
    const uint label = labelIn(plane, place, nearestVoxel(index));
    FurtherSegment seen;
    seen.label = label;
    seen.own = entryOf(label, place, nearestVoxel(index));
    seen.edge = false;
    for (int i = 0; i < 8; ++i) {
        const vec3 there = indexAt(pixel + around(i) * outlineWidth);
        seen.edge = seen.edge || labelIn(plane, place, nearestVoxel(there)) != label;
    }
#if PLANE
    const bool isMask = label != 0u && label == maskLabel;
    seen.own.rgb = isMask ? maskColour : seen.own.rgb;
    seen.edge = seen.edge && !isMask;
#endif
    return seen;
}

vec3 withFill(vec3 below, FurtherSegment segment)
{
    return mix(below, segment.own.rgb, segment.edge ? 0.0 : segment.own.a * fillOpacity);
}

vec3 withLine(vec3 below, FurtherSegment segment)
{
    return mix(below, segment.own.rgb, segment.edge ? segment.own.a : 0.0);
}
#endif

void main()
{
    const vec2 pixel = gl_FragCoord.xy * pixelScale + pixelJitter;
    const vec3 index = indexAt(pixel);
    const vec3 size = vec3(textureSize(intensity, 0));
    const bool isInside = all(greaterThanEqual(index, vec3(-0.5))) && all(lessThan(index, size - 0.5));
    const ivec3 voxel = nearestVoxel(index);
#if SLAB
    const float value = slabAt(index);
#else
    const float value = valueAt(index);
#endif
    const float grey = clamp(value * window.x + window.y, 0.0, 1.0);
    vec3 result = shownGrey(inverted ? 1.0 - grey : grey);
#if CARVED
    const float covered = texture(radiation, (index + 0.5) / size).r;
#endif
    // Segments are drawn in full over the hole.
#if SLAB
    result *= value < 0.0 ? 0.0 : 1.0;
#elif CARVED
    result *= carvedAsHole && covered >= 0.5 ? 0.0 : 1.0;
#endif

#if CHUNKS
    const vec4 chunk = chunkAt(index);
    bool meets = false; // chunks that touch differ in colour
    for (int i = 0; i < 8; i += 2)
        meets = meets || chunkAt(indexAt(pixel + around(i) * chunkWidth)) != chunk;
    const float chunkShare = chunkOpacity * (meets ? 2.0 : 1.0) * chunk.a;
    result = mix(result, chunk.rgb * (meets ? 0.8 : 1.0), min(chunkShare, 1.0));
    // The rim lies inside of its chunk.
    const vec4 chunkRim = chunkRimAt(index);
    bool chunkEnds = false;
    for (int i = 0; i < 8 && chunkRim.a > 0.0; i += 2)
        chunkEnds
            = chunkEnds || chunkRimAt(indexAt(pixel + around(i) * chunkRimWidth)) != chunkRim;
#endif

#if LABELED
    const uint label = labelAt(voxel);
    const vec4 entry = entryOf(label, 0u, voxel);
    bool edge = false;
    for (int i = 0; i < 8; ++i) {
        const vec3 there = indexAt(pixel + around(i) * outlineWidth);
        edge = edge || labelAt(nearestVoxel(there)) != label;
    }
    vec3 own = entry.rgb;
#if PLANE
    // The mask from which the surface came is reddish, so that the surface's line stands out
    // (seed B, figure 8).
    const bool isMask = label != 0u && label == maskLabel;
    own = isMask ? maskColour : own;
    edge = edge && !isMask;
#endif
#if LABEL_PLANES > 1
    // Fills of higher planes over those of lower ones, and all lines over all fills.
    const FurtherSegment segment1 = furtherSegment(labels1, 1u, index, pixel);
#if LABEL_PLANES > 2
    const FurtherSegment segment2 = furtherSegment(labels2, 2u, index, pixel);
#endif
#if LABEL_PLANES > 3
    const FurtherSegment segment3 = furtherSegment(labels3, 3u, index, pixel);
#endif
    result = mix(result, own, edge ? 0.0 : entry.a * fillOpacity);
    result = withFill(result, segment1);
#if LABEL_PLANES > 2
    result = withFill(result, segment2);
#endif
#if LABEL_PLANES > 3
    result = withFill(result, segment3);
#endif
    result = mix(result, own, edge ? entry.a : 0.0);
    result = withLine(result, segment1);
#if LABEL_PLANES > 2
    result = withLine(result, segment2);
#endif
#if LABEL_PLANES > 3
    result = withLine(result, segment3);
#endif
#else
    result = mix(result, own, entry.a * (edge ? 1.0 : fillOpacity));
#endif
#endif
#if CHUNKS
    // Over the line of the segment, which often is the border of a chunk.
    result = mix(result, chunkRim.rgb, chunkEnds ? chunkRim.a : 0.0);
#endif
#if CUT_PREVIEW
    const uint mark = previewMarkAt(voxel);
    bool border = false;
    for (int i = 0; i < 8; i += 2) {
        const vec3 there = indexAt(pixel + around(i) * cutPreviewWidth);
        border = border || previewMarkAt(nearestVoxel(there)) != mark;
    }
#if LABELED
    uint marksLabel = label;
#if LABEL_PLANES > 1
    marksLabel = growthPlace == 1u ? segment1.label : marksLabel;
#endif
#if LABEL_PLANES > 2
    marksLabel = growthPlace == 2u ? segment2.label : marksLabel;
#endif
#if LABEL_PLANES > 3
    marksLabel = growthPlace == 3u ? segment3.label : marksLabel;
#endif
    const vec4 marked = texelFetch(palette, ivec2(int(marksLabel), 0), 0);
    const vec3 marksOwn = marked.rgb;
    const float markShown
        = mark == growthReached || mark == growthReinstated ? marked.a : 1.0;
#else
    const vec3 marksOwn = vec3(1.0);
    const float markShown = 1.0;
#endif
    result = mix(result,
        border ? previewMarkLine(mark, marksOwn) : previewMarkColour(mark, pixel, marksOwn),
        mark != 0u ? (border ? 1.0 : 0.6) * markShown : 0.0);
#endif
#if CARVED
    float least = 1.0;
    for (int i = 0; i < 8; i += 2) {
        const vec3 there = indexAt(pixel + around(i) * carvedWidth);
        least = min(least, texture(radiation, (there + 0.5) / size).r);
    }
    const float tint = least < 0.5 ? 0.9 : carvedAsHole ? 0.0 : 0.10;
    result = mix(result, carvedColour, showCarved && covered >= 0.5 ? tint : 0.0);
#endif
#if PIECES
    // What has been lifted lies here, wherever it is shown in the 3D view.
    for (int k = 0; k < pieceCount; ++k) {
        const float held = footprintAt(k, index);
        if (held < 0.5)
            continue; // its line lies inside of it, too
        float rest = held;
        for (int i = 0; i < 8; i += 2)
            rest = min(rest, footprintAt(k, indexAt(pixel + around(i) * pieceWidth)));
        result = mix(result, pieceColour, rest < 0.5 ? 0.95 : 0.16);
    }
#endif
#if BARRIERS
    const bool isBarred = isBarrier(voxel);
    bool rim = false;
    for (int i = 0; i < 8; i += 2)
        rim = rim || isBarrier(nearestVoxel(indexAt(pixel + around(i) * barrierWidth))) != isBarred;
    const bool stripe = fract((pixel.x + pixel.y) / 8.0) < 0.4;
    result = mix(result, barrierColour, isBarred ? (rim || stripe ? 0.9 : 0.25) : 0.0);
#endif
#if PLANE
    colour = planeColour(result, isInside, pixel);
#else
    colour = vec4(isInside ? result : vec3(0.0), 1.0);
#endif
}
