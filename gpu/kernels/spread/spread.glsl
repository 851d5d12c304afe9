// Declarations that the kernels of growing from seeds share (core/growth/SeedSpread.h).
//
// A word is cost << 8 | label, so that the least word is the least (cost, label). Words lie in one
// texture of whole bricks around the box; what must not be entered is a wall.

#include "fields/bricks/bricks.glsl"

layout(binding = 0, r32ui) uniform coherent uimage3D words;
// One word per brick of the box: the least cost to which something near it has changed since it was
// processed, or `resting`. For bricks whose words may have become too small: only whether.
layout(binding = 1, std430) buffer Pending { uint pending[]; };
layout(binding = 2, std430) buffer Doubtful { uint doubtful[]; };

uniform ivec3 boxBricks; // in the texture
uniform ivec3 firstBrick; // of the volume

const uint wall = 0u;
const uint unreached = 0xFFFFFFFFu;
const uint resting = 0xFFFFFFFFu;
const uint leastPathWord = 256u; // words below it are seeds, because a step costs at least 1

// One bit for each brick around a brick, including itself (bit 13) …
const uint itself = 1u << 13;
#if CONNECTIVITY == 6
const uint reachable = itself | 1u << 12 | 1u << 14 | 1u << 10 | 1u << 16 | 1u << 4 | 1u << 22;
#elif CONNECTIVITY == 18
const uint reachable = 0x07FFFFFFu ^ (1u | 1u << 2 | 1u << 6 | 1u << 8 | 1u << 18 | 1u << 20
    | 1u << 24 | 1u << 26);
#else
const uint reachable = 0x07FFFFFFu;
#endif

uint sideBits(int place)
{
    return 2u | uint(place == 0) | uint(place == 15) << 2;
}

// … in which neighbours of one of its voxels lie.
uint bricksBeside(ivec3 local)
{
    uvec3 sides = uvec3(sideBits(local.x), sideBits(local.y), sideBits(local.z));
    uint row = sides.x * ((sides.y & 1u) | (sides.y & 2u) << 2 | (sides.y & 4u) << 4);
    uint block = row * ((sides.z & 1u) | (sides.z & 2u) << 8 | (sides.z & 4u) << 16);
    return block & reachable;
}

// The index of the brick that a bit stands for; -1 outside the box.
int brickBeside(ivec3 brick, uint bit)
{
    ivec3 other = brick + ivec3(int(bit % 3u), int(bit / 3u % 3u), int(bit / 9u)) - 1;
    return inside(other, boxBricks) ? brickIndex(other, boxBricks) : -1;
}

// The word that a neighbour offers. Neither a wall (0) nor an unreached voxel offers anything,
// because both wrap around.
uint offered(uint there, uint stepCost)
{
    uint base = there - 1u;
    uint sum = base + (stepCost + 1u << 8);
    return sum < base ? unreached : sum - 255u;
}
