// Which voxels in the candidate bricks of a brush that follows edges are alike, a bit for each
// (core/sculpt/EdgeRegion.h, rule 2). One work-group per brick; an invocation writes whole words.

layout(local_size_x = 64) in;

#include "fields/bricks/bricks.glsl"
#include "kernels/sculpt/capsule.glsl"

layout(binding = 0) uniform usampler3D codes;
layout(binding = 4, std430) writeonly buffer Alike { uint alike[]; };

uniform uint lowCode;
uniform uint highCode;
uniform int value; // where the stroke begins
uniform int tolerance;

const int wordsPerBrick = 128;

bool isAlike(Candidate candidate, ivec3 local)
{
    ivec3 voxel = brickPosition(candidate.base.w, volumeBricks) * brickSide + local;
    if (!inside(voxel, volumeSize))
        return false;
    uint code = texelFetch(codes, voxel, 0).r;
    if (code < lowCode || code > highCode)
        return false;
    ivec3 position = strokePosition(candidate, local);
    if (!inSlab(position))
        return false;
    int difference = abs(int(code) - value);
    for (uint i = candidate.span.x; i < candidate.span.y; ++i) {
        Capsule capsule = capsules[near[i]];
        if (difference <= tolerance * strengthOf(capsule) / 255 && pieceHolds(capsule, position))
            return true;
    }
    return false;
}

void main()
{
    Candidate candidate = candidates[gl_WorkGroupID.x];
    for (int word = int(gl_LocalInvocationID.x); word < wordsPerBrick; word += 64) {
        uint bits = 0u;
        for (int bit = 0; bit < 32; ++bit) {
            if (isAlike(candidate, voxelInBrick(32 * word + bit)))
                bits |= 1u << bit;
        }
        alike[int(gl_WorkGroupID.x) * wordsPerBrick + word] = bits;
    }
}
