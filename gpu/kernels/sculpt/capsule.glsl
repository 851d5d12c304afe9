// Computes the distance of a voxel from the pieces of a brush's path (core/sculpt/CapsuleSweep.h,
// rules 1 to 3), for the pieces that are near its brick.

struct Capsule {
    ivec4 from;      // mm16; w: length, mm16
    // unit vector · 2¹⁴; w: by how much its radius is smaller, mm16, in 24 bits, above them how much
    // of the tolerance counts, 0 … 255
    ivec4 direction;
};
struct Candidate {
    ivec4 base;  // stroke coordinates of the brick's first voxel, mm16; w: the brick
    uvec4 span; // range of its pieces in `near`: first, one past the last
};
layout(binding = 0, std430) readonly buffer Candidates { Candidate candidates[]; };
layout(binding = 1, std430) readonly buffer Capsules { Capsule capsules[]; };
layout(binding = 2, std430) readonly buffer Near { uint near[]; };
// Whether each candidate has changed.
layout(binding = 3, std430) buffer Changed { uint changed[]; };

uniform ivec3 volumeSize;
uniform ivec3 volumeBricks;
uniform ivec3 perI; // mm16
uniform ivec3 perJ;
uniform ivec3 perK;
uniform bool isFlat;
uniform bool isSquare;
uniform int halfThickness;
uniform int radius;
uniform int reach;
uniform int shift;

const uint farAway = 0xFFFFFFFFu;

ivec3 strokePosition(Candidate candidate, ivec3 local)
{
    return candidate.base.xyz + local.x * perI + local.y * perJ + local.z * perK;
}

bool inSlab(ivec3 position)
{
    return !isFlat || abs(position.z) <= halfThickness;
}

int product(ivec3 a, ivec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

int radiusOf(Capsule capsule)
{
    return max(radius - (capsule.direction.w & 0xFFFFFF), 0);
}

int strengthOf(Capsule capsule)
{
    return (capsule.direction.w >> 24) & 255;
}

// The least half side with which a square or cube on its way along u holds q, in units.
uint squareDistance(ivec3 q, ivec3 u, int unitLength)
{
    ivec3 end = unitLength * u;
    ivec3 fine = q * 16384;
    ivec3 outside = max(max(fine - max(end, ivec3(0)), min(end, ivec3(0)) - fine), ivec3(0));
    ivec3 along = (outside + 16383) >> 14;
    // Beside the line, in each of the planes of two axes.
    uvec3 beside = uvec3(abs(q.yzx * u.zxy - q.zxy * u.yzx));
    uvec3 size = max(uvec3(abs(u.yzx) + abs(u.zxy)), uvec3(1u));
    uvec3 across = (beside + size - 1u) / size;
    uvec3 most = max(uvec3(along), across);
    return max(most.x, max(most.y, most.z));
}

// The squared distance, in units; farAway if the piece has no distance to the position.
uint squaredDistance(Capsule capsule, ivec3 position)
{
    ivec3 a = position - capsule.from.xyz;
    if (isFlat)
        a.z = 0;
    if (any(greaterThan(abs(a), ivec3(reach))))
        return farAway;
    ivec3 q = a >> shift;
    ivec3 u = capsule.direction.xyz;
    if (isSquare) {
        uint away = squareDistance(q, u, capsule.from.w >> shift);
        return away * away;
    }
    int h = clamp((product(q, u) + 8192) >> 14, 0, capsule.from.w >> shift);
    ivec3 e = q - ((h * u + 8192) >> 14);
    return uint(product(e, e));
}

// Whether a place in the slab is within the radius of a piece (rule 4).
bool pieceHolds(Capsule capsule, ivec3 position)
{
    uint unitRadius = uint(radiusOf(capsule) >> shift);
    return squaredDistance(capsule, position) <= unitRadius * unitRadius;
}

// Whether the voxel is within the radius of a piece near the candidate.
bool isWithin(Candidate candidate, ivec3 local)
{
    ivec3 position = strokePosition(candidate, local);
    if (!inSlab(position))
        return false;
    for (uint i = candidate.span.x; i < candidate.span.y; ++i) {
        if (pieceHolds(capsules[near[i]], position))
            return true;
    }
    return false;
}

// The least distance over the pieces near the candidate.
uint leastDistance(Candidate candidate, ivec3 local)
{
    ivec3 position = strokePosition(candidate, local);
    uint least = farAway;
    if (!inSlab(position))
        return least;
    for (uint i = candidate.span.x; i < candidate.span.y; ++i)
        least = min(least, squaredDistance(capsules[near[i]], position));
    return least;
}
