// Addresses in the grid of 16³ bricks and in the atlas of pages that holds the bricks which are not
// empty (BrickField).

const int brickSide = 16;

int brickIndex(ivec3 brick, ivec3 bricks)
{
    return brick.x + bricks.x * (brick.y + bricks.y * brick.z);
}

ivec3 brickPosition(int brick, ivec3 bricks)
{
    return ivec3(brick % bricks.x, brick / bricks.x % bricks.y, brick / (bricks.x * bricks.y));
}

// The local voxel of an offset 0 … 4095 in a brick, x fastest.
ivec3 voxelInBrick(int offset)
{
    return ivec3(offset & 15, offset >> 4 & 15, offset >> 8);
}

int offsetInBrick(ivec3 voxel)
{
    return (voxel.x & 15) | (voxel.y & 15) << 4 | (voxel.z & 15) << 8;
}

// The texel of a voxel in a page. A page fills two rows of the atlas, with 1024 pages per slice: if
// textures are stored linearly in memory a brick is contiguous, and a walk through it stays in the
// cache.
ivec3 pageTexel(uint page, int offset)
{
    return ivec3(offset & 2047, int(page & 1023u) << 1 | offset >> 11, int(page >> 10));
}

// A page table holds page + 1, and 0 where a brick has no page.
ivec3 atlasTexel(uint entry, ivec3 voxel)
{
    return pageTexel(entry - 1u, offsetInBrick(voxel));
}

bool inside(ivec3 voxel, ivec3 size)
{
    return all(greaterThanEqual(voxel, ivec3(0))) && all(lessThan(voxel, size));
}
