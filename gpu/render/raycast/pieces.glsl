// Pieces: parts of the volume in poses of their own. Each is the same volume seen along another
// ray: the pixel's ray transformed to the piece's true place. t is the same on both, so hits and
// samples of all pieces are ordered by t. Included if PIECES is on; then SCULPTED is on, too.

struct Piece {
    vec4 toTrue[3]; // rows: texture position as shown → texture position at its true place
    vec4 turn[3]; // columns: directions in world space, true place → as shown
    vec4 low; // texture: the box that it fills; w: opacity
    vec4 high;      // w: 1 / zoom
    vec4 atlas; // texel of footprints = index-based position · size + xyz; w: softness
    vec4 atlasLow; // its outermost texel centres; w: 1 if it is solid
    vec4 atlasHigh; // w: row of its own transfer function, −1: it uses the scene's
    vec4 colour; // tint, or the colour of a solid piece
    vec4 cellLow; // its outermost cells, in the volume; w: x of the transfer function's entry
    vec4 cellHigh; // w: y of the transfer function's entry
    vec4 cells;     // cell of pieceCells = cell + xyz
};
layout(binding = 0, std430) readonly buffer Pieces { Piece pieces[]; };

/* Textures */
// ≥ 0.5: belongs to the piece; all footprints in one texture
layout(binding = 9) uniform sampler3D footprints;
layout(binding = 10) uniform usampler3D pieceCells; // greatest footprint of each cell
layout(binding = 11) uniform sampler2D pieceTransfers; // one row per piece

/* Uniforms */
uniform int pieceCount;
uniform int homeCount; // the first so many are at home, opaque and untinted

const uint shownFlag = 8u;
const int restOf = -1; // the rest of the volume, as a piece

bool isSolid(int piece)
{
    return pieces[piece].atlasLow.w > 0.5;
}

/// The pixel's ray at a piece's true place; first > last if it does not meet the piece.
Ray pieceRay(Ray ray, int piece)
{
    const vec4 x = pieces[piece].toTrue[0];
    const vec4 y = pieces[piece].toTrue[1];
    const vec4 z = pieces[piece].toTrue[2];
    const vec4 origin = vec4(ray.origin, 1.0);
    Ray turned = ray;
    turned.origin = vec3(dot(x, origin), dot(y, origin), dot(z, origin));
    turned.direction
        = vec3(dot(x.xyz, ray.direction), dot(y.xyz, ray.direction), dot(z.xyz, ray.direction));
    const vec3 low = max(pieces[piece].low.xyz, clipLow);
    const vec3 high = min(pieces[piece].high.xyz, clipHigh);
    setBounds(turned, low, high);
    // All of it is clipped.
    turned.last = any(greaterThanEqual(low, high)) ? turned.first - 1.0 : turned.last;
    return turned;
}

/// A direction at a piece's true place transformed to how it is shown, and back.
vec3 asShown(int piece, vec3 v)
{
    if (piece < 0)
        return v;
    return pieces[piece].turn[0].xyz * v.x + pieces[piece].turn[1].xyz * v.y
        + pieces[piece].turn[2].xyz * v.z;
}
vec3 asTrue(int piece, vec3 v)
{
    if (piece < 0)
        return v;
    return vec3(dot(pieces[piece].turn[0].xyz, v), dot(pieces[piece].turn[1].xyz, v),
        dot(pieces[piece].turn[2].xyz, v));
}

float footprintAt(int piece, vec3 at)
{
    const vec3 texel = clamp(at / voxel + pieces[piece].atlas.xyz, pieces[piece].atlasLow.xyz,
        pieces[piece].atlasHigh.xyz);
    return texture(footprints, texel / vec3(textureSize(footprints, 0))).r;
}

/// gapAt() from known values: the piece's footprint, and the radiation.
float gapOf(int piece, float own, float carved, vec3 at)
{
    float gap = carved;
#if HOME
    for (int k = 0; k < homeCount; ++k)
        gap -= footprintAt(k, at);
#endif
    return piece >= homeCount ? 1.0 - own : max(gap, 0.0);
}

/// The opacity of a piece for a value of its footprint: greater at a soft edge than inside.
float opacityAt(int piece, float own)
{
    const float softness = pieces[piece].atlas.w;
    const float fade = softness > 0.0 ? clamp(1.0 - (2.0 * own - 1.0) / softness, 0.0, 1.0) : 0.0;
    return max(pieces[piece].low.w, fade);
}

/// How much is carved away at a place as far as its look is concerned. Pieces that are at home have
/// no cut: what they fill is not missing, and for them their surroundings are not missing.
float gapAt(int piece, vec3 at)
{
    const float own = piece >= homeCount ? footprintAt(piece, at) : 0.0;
    return gapOf(piece, own, texture(radiation, at).r, at);
}

vec3 gapRise(int piece, vec3 at)
{
    const vec3 h = voxel;
    return vec3(gapAt(piece, at + vec3(h.x, 0, 0)) - gapAt(piece, at - vec3(h.x, 0, 0)),
               gapAt(piece, at + vec3(0, h.y, 0)) - gapAt(piece, at - vec3(0, h.y, 0)),
               gapAt(piece, at + vec3(0, 0, h.z)) - gapAt(piece, at - vec3(0, 0, h.z)))
        * 0.5;
}

vec3 footprintRise(int piece, vec3 at)
{
    const vec3 h = voxel;
    return vec3(footprintAt(piece, at + vec3(h.x, 0, 0)) - footprintAt(piece, at - vec3(h.x, 0, 0)),
               footprintAt(piece, at + vec3(0, h.y, 0)) - footprintAt(piece, at - vec3(0, h.y, 0)),
               footprintAt(piece, at + vec3(0, 0, h.z)) - footprintAt(piece, at - vec3(0, 0, h.z)))
        * 0.5;
}

/// Whether nothing of a piece is visible in a cell of the volume.
bool isFreeOf(int piece, vec3 cell)
{
#ifdef EVERY_SAMPLE
    return false;
#endif
    const vec3 own = clamp(cell, pieces[piece].cellLow.xyz, pieces[piece].cellHigh.xyz);
    const uint greatest = texelFetch(pieceCells, ivec3(own + pieces[piece].cells.xyz), 0).r;
    const bool everyValue = isSolid(piece) || pieces[piece].atlasHigh.w >= 0.0;
    return greatest < 128u || (!everyValue && (skipAt(own).y & shownFlag) == 0u);
}

/// The first sample at or after n that is not in a free cell; n itself if it is in none.
float leaveFreeCells(int piece, Samples samples, float n)
{
    for (;;) {
        const vec3 cell = cellOf(samples, n);
        if (n >= samples.last || !isFreeOf(piece, cell))
            break;
        n = max(floor(n), floor(leaves(samples, cell, 0.0))) + 1.0;
    }
    return n;
}
