// Declarations shared by the kernels that find out where a ball fits (core/growth/Passage.h,
// PassageField).
//
// For each brick that matters to a label there is a page of four sets of 4096 voxels, one bit per
// voxel: 16 bits per row, two rows per word. A job is a brick of a label.

#include "fields/bricks/bricks.glsl"

struct PassageJob {
    uint brick;
    uint slot; // of the label
    uint label;
    uint page;
};
layout(binding = 4, std430) readonly buffer Jobs { PassageJob jobs[]; };
layout(binding = 6, std430) coherent buffer Bits { uint bits[]; };
layout(binding = 7, std430) readonly buffer BitPages { uint bitPages[]; }; // slot, brick: page + 1

const uint blockedSet = 0u; // voxels that are not free
const uint seedSet = 1u;
const uint centreSet = 2u;
const uint entrySet = 3u; // centres whose ball holds a seed

const uint wordsPerSet = 128u;

uint bitWord(uint page, uint set, uint rowPair)
{
    return (page * 4u + set) * wordsPerSet + rowPair;
}
