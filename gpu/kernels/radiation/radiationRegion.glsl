// The region on which a group of radiation*.comp works: a box of voxels in one brick, low ≤ local <
// low + size. Its scratch memory is that of the whole brick; only what the box needs is filled.

layout(binding = 0, std430) readonly buffer Regions { uvec2 regions[]; };

struct Region {
    int brick;
    ivec3 low;
    ivec3 size;
};

Region regionOf(uint slot)
{
    uvec2 region = regions[slot];
    ivec3 low = ivec3(region.y, region.y >> 5, region.y >> 10) & 31;
    ivec3 high = ivec3(region.y >> 15, region.y >> 20, region.y >> 25) & 31;
    return Region(int(region.x), low, high - low);
}

// Enumerates the voxels of boxes of up to 24³, x fastest. Divides by multiplication, which is exact
// because number · extent stays below 2²².
struct Box {
    uint count;
    uvec2 extent;
    uvec2 reciprocal;
};

Box boxOf(ivec3 size)
{
    uvec2 extent = uvec2(size.xy);
    return Box(extent.x * extent.y * uint(size.z), extent, ((1u << 22) + extent - 1u) / extent);
}

ivec3 voxelOf(uint number, Box box)
{
    uint row = number * box.reciprocal.x >> 22;
    uint slice = row * box.reciprocal.y >> 22;
    return ivec3(number - row * box.extent.x, row - slice * box.extent.y, slice);
}
