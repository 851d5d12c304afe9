// Fronts as bits, one a voxel (FrontBits): 128 words a brick, by brick. A word holds two rows of 16
// voxels: bit b of word w is the voxel of offset 32 w + b. To be included after growth.glsl.

struct ListedBrick {
    uint index; // in the grid
    uint page;
    uint x; // of its position, in bricks
    uint yz; // y | z << 16
};
// A list begins with the groups of a dispatch over it.
layout(binding = 4, std430) restrict readonly buffer Bricks {
    uvec4 groups;
    ListedBrick bricks[];
};

const uint wordsOfFront = 128u; // of a brick

// What a growth may still claim of a brick: 128 words, and behind them the last generation that had
// a front in the brick, and in the layer of its voxels at either end: -x, +x, -y, +y, -z, +z.
const uint wordsOfOpen = 136u;
const uint lastFront = 128u;
const uint lastFrontAtEnd = 129u;

// A division costs a software renderer more than all else here, so positions are told.
ivec3 positionOf(ListedBrick brick)
{
    return ivec3(brick.x, brick.yz & 0xFFFFu, brick.yz >> 16);
}
