// The last front of a batch shows its labels too (growRing writes those of the fronts before).

layout(local_size_x = 64) in;

#include "kernels/growth/growth.glsl"

uniform uint ring;

void main()
{
    showFront(ring, gl_GlobalInvocationID.x, gl_NumWorkGroups.x * gl_WorkGroupSize.x);
}
