// Adds the footprints of sparse points to the sums of their tiles (core/sculpt/radiation/SparseRadiation.h).
// One work-group per footprint: its invocations divide the x-y plane, where the product of two
// weights is the same for the whole row along z.

layout(local_size_x = 64) in;

const int tileSide = 19;
const int longest = 17;

struct Footprint {
    ivec4 first; // in its tile; w: the tile
    ivec4 count; // w: label
    uint weights[3 * longest + 1];
};

layout(binding = 0, std430) readonly buffer Footprints { Footprint footprints[]; };
// two per voxel: the sum; the greatest share and its label
layout(binding = 1, std430) buffer Sums { uint sums[]; };

// a · b >> 28 for numbers up to 2²⁸.
uint product(uint a, uint b)
{
    uint high;
    uint low;
    umulExtended(a << 2, b << 2, high, low);
    return high;
}

void main()
{
    uint number = gl_WorkGroupID.x;
    ivec3 first = footprints[number].first.xyz;
    ivec4 count = footprints[number].count;
    int slot = footprints[number].first.w;
    for (int i = int(gl_LocalInvocationID.x); i < count.x * count.y; i += 64) {
        ivec2 at = ivec2(i % count.x, i / count.x);
        ivec2 voxel = first.xy + at;
        if (any(lessThan(voxel, ivec2(0))) || any(greaterThanEqual(voxel, ivec2(tileSide))))
            continue;
        uint plane = product(
            footprints[number].weights[at.x], footprints[number].weights[longest + at.y]);
        int from = max(-first.z, 0);
        int to = min(tileSide - first.z, count.z);
        for (int z = from; z < to; ++z) {
            uint weight = product(plane, footprints[number].weights[2 * longest + z]);
            uint part = (weight + (1u << 7)) >> 8;
            if (part == 0u)
                continue;
            int place = 2
                * (voxel.x + tileSide * (voxel.y + tileSide * (first.z + z + tileSide * slot)));
            atomicAdd(sums[place], part);
            atomicMax(sums[place + 1], part << 8 | uint(count.w));
        }
    }
}
