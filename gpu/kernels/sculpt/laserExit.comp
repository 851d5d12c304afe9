// Finds where the material under the feet of a laser's beams ends (core/sculpt/LaserCut.h, rule 7).
// One invocation per beam.

layout(local_size_x = 64) in;

#include "kernels/cut/snapshot.glsl"

struct Beam {
    ivec4 foot; // index16; w: the first visible sample
    ivec4 perStep; // index16; w: one past the last visible sample
};
layout(binding = 0, std430) readonly buffer Beams { Beam beams[]; };
layout(binding = 1, std430) writeonly buffer Exits { int exits[]; }; // first sample of the gap

uniform uint beamCount;
uniform int sampleCount;
uniform int gapSamples;
uniform bool restoring; // whether to look for the end of what is carved

int endOfCarved(Beam beam)
{
    int end = 0;
    for (int n = max(beam.foot.w, 0); n < min(beam.perStep.w, sampleCount); ++n) {
        ivec3 p = beam.foot.xyz + n * beam.perStep.xyz;
        if (!denseHere(p))
            continue;
        if (!carvedHere(p))
            break;
        end = n + 1;
    }
    return end;
}

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= beamCount)
        return;
    Beam beam = beams[i];
    if (restoring) {
        exits[i] = endOfCarved(beam);
        return;
    }
    int exit = 0;
    int run = 0;
    for (int n = 1; n < sampleCount; ++n) {
        if (n >= beam.foot.w && n < beam.perStep.w
            && materialHere(beam.foot.xyz + n * beam.perStep.xyz)) {
            run = 0;
        } else if (++run == gapSamples) {
            exit = n - run + 1;
            break;
        }
    }
    exits[i] = exit;
}
