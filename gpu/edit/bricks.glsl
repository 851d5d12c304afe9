// The grid of 16³ bricks and the atlas that holds those that are not empty (BrickField).

const int brickSide = 16;

int brickIndex(ivec3 brick, ivec3 bricks)
{
    return brick.x + bricks.x * (brick.y + bricks.y * brick.z);
}

ivec3 brickPosition(int brick, ivec3 bricks)
{
    return ivec3(brick % bricks.x, brick / bricks.x % bricks.y, brick / (bricks.x * bricks.y));
}

// Local voxel of an offset 0 … 4095, x fastest.
ivec3 voxelInBrick(int offset)
{
    return ivec3(offset & 15, offset >> 4 & 15, offset >> 8);
}

// First atlas texel of a page; pages lie 32 × 32 to a slab of 16 texels.
ivec3 pageOrigin(uint page)
{
    return ivec3(int(page & 31u), int(page >> 5 & 31u), int(page >> 10)) * brickSide;
}

// A page table holds page + 1, and 0 where a brick has no page.
ivec3 atlasTexel(uint entry, ivec3 voxel)
{
    return pageOrigin(entry - 1u) + (voxel & 15);
}

bool inside(ivec3 voxel, ivec3 size)
{
    return all(greaterThanEqual(voxel, ivec3(0))) && all(lessThan(voxel, size));
}
