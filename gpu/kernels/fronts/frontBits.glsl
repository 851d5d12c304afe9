// Growth fronts as bits, one per voxel (FrontBits): 128 words per brick. A word holds two rows of
// 16 voxels: bit b of word w is the voxel at offset 32 w + b. Include this file after growth.glsl.

struct ListedBrick {
    uint index; // index in the grid
    uint page;
    uint x; // position in bricks
    uint yz; // y | z << 16
};
// The list begins with the group counts of a dispatch over it, a group for each brick; of a dispatch
// with fewer, the groups walk.
layout(binding = 4, std430) restrict readonly buffer Bricks {
    uvec4 groups;
    ListedBrick bricks[];
};

const uint wordsOfFront = 128u; // words per brick

// For each brick, the voxels that a growth may still claim (128 words), followed by the last
// generation with a front in the brick, and in the layer of voxels at each of its ends: -x, +x, -y,
// +y, -z, +z.
const uint wordsOfOpen = 136u;
const uint lastFront = 128u;
const uint lastFrontAtEnd = 129u;

// Positions are stored because a division would cost a software renderer more than everything else
// here.
ivec3 positionOf(ListedBrick brick)
{
    return ivec3(brick.x, brick.yz & 0xFFFFu, brick.yz >> 16);
}
