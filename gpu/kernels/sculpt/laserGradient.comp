// Computes the direction of the material around the feet of a laser's beams
// (core/sculpt/LaserCut.h, rule 3). One work-group per beam; its sum consists of integers, so the
// order does not matter.

layout(local_size_x = 64) in;

#include "kernels/cut/snapshot.glsl"

struct Foot {
    ivec4 position; // index16
    ivec4 sum;
};
layout(binding = 0, std430) buffer Feet { Foot feet[]; };
// For every foot and hidden half space: its distance, and its increments along u, v, w.
layout(binding = 4, std430) readonly buffer FeetHidden { ivec4 feetHidden[]; };

uniform ivec3 latticeU; // index16
uniform ivec3 latticeV;
uniform ivec3 latticeW;
uniform int reach;
uniform int hiddenCount;

bool hiddenAt(uint foot, ivec3 o)
{
    for (int i = 0; i < hiddenCount; ++i) {
        ivec4 side = feetHidden[foot * uint(hiddenCount) + uint(i)];
        ivec3 terms = side.yzw * o;
        if (side.x + terms.x + terms.y + terms.z > 0)
            return true;
    }
    return false;
}

void main()
{
    uint foot = gl_WorkGroupID.x;
    ivec3 position = feet[foot].position.xyz;
    int side = 2 * reach + 1;
    ivec3 sum = ivec3(0);
    for (int i = int(gl_LocalInvocationID.x); i < side * side * side; i += 64) {
        ivec3 o = ivec3(i % side, i / side % side, i / (side * side)) - reach;
        if (o.x * o.x + o.y * o.y + o.z * o.z > reach * reach || hiddenAt(foot, o))
            continue;
        if (materialHere(position + o.x * latticeU + o.y * latticeV + o.z * latticeW))
            sum += o;
    }
    atomicAdd(feet[foot].sum.x, sum.x);
    atomicAdd(feet[foot].sum.y, sum.y);
    atomicAdd(feet[foot].sum.z, sum.z);
}
