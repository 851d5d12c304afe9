// Computes room and entry of every voxel of a brick (core/growth/Passage.h): room | entry << 16.
// One work-group per job; the bits of passageCentres.comp exist for all bricks around it.

layout(local_size_x = 64) in;

uniform ivec3 volumeSize;
uniform ivec3 volumeBricks;

#include "kernels/passage/passageDistance.glsl"
#include "kernels/passage/passageSlots.glsl"

layout(binding = 0, r32ui) uniform uimage3D rooms; // atlas

void main()
{
    PassageJob job = jobs[gl_WorkGroupID.x];
    ivec3 brick = brickPosition(int(job.brick), volumeBricks);
    uint entry = texelFetch(roomPages, slotBrick(brick, job.slot), 0).r;
    lookAlongXy(job, centreSet, false);
    for (int offset = int(gl_LocalInvocationID.x); offset < 4096; offset += 64)
        imageStore(rooms, pageTexel(entry - 1u, offset), uvec4(squareAt(voxelInBrick(offset))));
    barrier();
    lookAlongXy(job, entrySet, false);
    for (int offset = int(gl_LocalInvocationID.x); offset < 4096; offset += 64) {
        ivec3 texel = pageTexel(entry - 1u, offset);
        uint room = imageLoad(rooms, texel).r;
        imageStore(rooms, texel, uvec4(room | squareAt(voxelInBrick(offset)) << 16));
    }
}
