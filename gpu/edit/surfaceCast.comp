// Where mask elements meet the surface as it was when the edit began, and where the material behind
// it ends (core/sculpt/MaskFrame.h, rules 2 to 5). One invocation a ray.

layout(local_size_x = 64) in;

#include "edit/asItBegan.glsl"

layout(binding = 2) uniform sampler3D codeRanges; // macro-cells: least and greatest code
layout(binding = 0, std430) readonly buffer Rays { ivec4 rays[]; };     // index16 at sample 0
layout(binding = 1, std430) writeonly buffer Hits { ivec2 hits[]; };    // zSurface, zExit (mm16)
layout(binding = 4, std430) readonly buffer Seen { ivec2 seen[]; };     // first sample, one past the last

uniform uint rayCount;
uniform ivec3 stepPerSample; // index16
uniform int zStart;
uniform int zPerSample;
uniform int maxDepth;
uniform int gapSamples;
uniform bool throughGaps;

const int nowhere = 0x7FFFFFFF;

ivec3 at(ivec3 origin, int n, int sixteenths)
{
    return origin + n * stepPerSample + ((sixteenths * stepPerSample) >> 4);
}

int heightAt(int n, int sixteenths)
{
    return zStart + n * zPerSample + ((sixteenths * zPerSample) >> 4);
}

// Samples whose position can lie inside the volume: others need not be looked at.
ivec2 samplesInside(ivec3 origin, ivec2 range)
{
    ivec2 all = range;
    for (int axis = 0; axis < 3; ++axis) {
        float perSample = float(stepPerSample[axis]);
        float low = float(-origin[axis] - (1 << 15));
        float high = low + float(volumeSize[axis] << 16);
        if (stepPerSample[axis] == 0) {
            if (low > 0.0 || high < 0.0)
                return ivec2(0);
            continue;
        }
        float a = low / perSample;
        float b = high / perSample;
        // Two samples of margin are far more than the rounding of floats here.
        range.x = max(range.x, int(clamp(floor(min(a, b)) - 2.0, 0.0, float(all.y))));
        range.y = min(range.y, int(clamp(ceil(max(a, b)) + 3.0, 0.0, float(all.y))));
    }
    return range;
}

// How many samples, p the first of them, lie in a macro-cell of which no sample is dense; 0: it is
// none. Skips what the rules would look at in vain, so it decides nothing.
int samplesInEmptyCell(ivec3 p)
{
    ivec3 cell = p >> 19;
    if (any(lessThan(p, ivec3(0))) || any(greaterThanEqual(cell, textureSize(codeRanges, 0)))
        || int(texelFetch(codeRanges, cell, 0).g * 65535.0 + 0.5) >= thresholdCode)
        return 0;
    int samples = 0x7FFFF; // the finest step
    for (int axis = 0; axis < 3; ++axis) {
        int perSample = stepPerSample[axis];
        int within = p[axis] & 0x7FFFF;
        if (perSample != 0)
            samples = min(samples, (perSample > 0 ? 0x7FFFF - within : within) / abs(perSample) + 1);
    }
    return samples;
}

void main()
{
    uint ray = gl_GlobalInvocationID.x;
    if (ray >= rayCount)
        return;
    ivec3 origin = rays[ray].xyz;
    ivec2 range = samplesInside(origin, seen[ray]);
    int first = range.x;
    int lastCarved = -1;
    for (; first < range.y; ++first) {
        ivec3 p = at(origin, first, 0);
        int empty = samplesInEmptyCell(p);
        if (empty > 0) {
            first += empty - 1;
            continue;
        }
        if (!dense(p, thresholdCode))
            continue;
        if (!carvedHere(p))
            break;
        lastCarved = first;
    }
    if (restore && lastCarved >= 0 && (first >= range.y || lastCarved + 1 < first)) {
        hits[ray] = ivec2(heightAt(lastCarved + 1, 0), nowhere);
        return;
    }
    if (first >= range.y || (restore && lastCarved < 0)) {
        hits[ray] = ivec2(nowhere);
        return;
    }
    int low = (first - 1) * 16;
    int high = first * 16;
    for (int halving = 0; halving < 4 && first > seen[ray].x; ++halving) {
        int middle = (low + high) / 2;
        if (materialHere(at(origin, middle / 16, middle % 16)))
            high = middle;
        else
            low = middle;
    }
    int surface = heightAt(high / 16, high % 16);

    int exit = nowhere;
    int run = 0;
    for (int n = first + 1; !throughGaps && !restore && n < seen[ray].y && heightAt(n, 0) <= surface + maxDepth;
         ++n) {
        if (materialHere(at(origin, n, 0))) {
            run = 0;
        } else if (++run == gapSamples) {
            exit = heightAt(n - run + 1, 0);
            break;
        }
    }
    hits[ray] = ivec2(surface, exit);
}
