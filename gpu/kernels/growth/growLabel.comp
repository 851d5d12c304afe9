// Writes the labels of the last front of a batch (growRing.comp writes those of the fronts before).

layout(local_size_x = 64) in;

#include "kernels/criterion/growth.glsl"

uniform uint ring;

void main()
{
    showFront(ring, gl_GlobalInvocationID.x, gl_NumWorkGroups.x * gl_WorkGroupSize.x);
}
