// Finds where rays from mask elements meet the surface as it was when the edit began, and where the
// material behind it ends (core/sculpt/CutFrame.h, rules 2 to 5). One invocation per ray.

layout(local_size_x = 64) in;

#include "kernels/cut/snapshot.glsl"

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
uniform int front;

const int nowhere = 0x7FFFFFFF;

ivec3 at(ivec3 origin, int n, int sixteenths)
{
    return origin + n * stepPerSample + ((sixteenths * stepPerSample) >> 4);
}

int heightAt(int n, int sixteenths)
{
    return zStart + n * zPerSample + ((sixteenths * zPerSample) >> 4);
}

// The range of samples whose position can lie inside the volume; others need not be examined.
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
        // A margin of two samples is far more than the rounding error of floats here.
        range.x = max(range.x, int(clamp(floor(min(a, b)) - 2.0, 0.0, float(all.y))));
        range.y = min(range.y, int(clamp(ceil(max(a, b)) + 3.0, 0.0, float(all.y))));
    }
    return range;
}

// The number of samples, starting with p, in a macro-cell without any dense sample; 0 if the cell
// may hold one. It only skips samples that the rules would examine in vain, so it decides nothing.
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

bool hollow(ivec3 p)
{
    return denseHere(p) && carvedHere(p);
}

bool holds(ivec3 p, bool whereHollow, bool expected)
{
    return (whereHollow ? hollow(p) : materialHere(p)) == expected;
}

// The height, found by bisection between two samples, where being hollow (or else being material)
// changes to the expected state.
int turnsAt(ivec3 origin, int after, bool whereHollow, bool expected)
{
    int low = (after - 1) * 16;
    int high = after * 16;
    for (int halving = 0; halving < 4; ++halving) {
        int middle = (low + high) / 2;
        if (holds(at(origin, middle / 16, middle % 16), whereHollow, expected))
            high = middle;
        else
            low = middle;
    }
    return heightAt(high / 16, high % 16);
}

// When restoring, if no sample before the first material is hollow: whether the place right in
// front of it is carved.
bool carvedInFront(ivec3 origin, int first, int seenFrom)
{
    for (int n = first - 1; n >= seenFrom && heightAt(first, 0) - heightAt(n, 0) <= 2 * front; --n) {
        ivec3 p = at(origin, n, 0);
        if (insideVolume(p) && carvedHere(p))
            return true;
    }
    return false;
}

// When restoring: zSurface and zOuter. `first` is the first sample of material, or beyond the last
// sample.
ivec2 hollowOf(ivec3 origin, int first, int last, ivec2 hollowSamples, int seenFrom)
{
    if (hollowSamples.y >= 0)
        return ivec2(turnsAt(origin, hollowSamples.y + 1, true, false),
            hollowSamples.x > seenFrom ? turnsAt(origin, hollowSamples.x, true, true)
                                       : heightAt(hollowSamples.x, 0));
    if (first < last && carvedInFront(origin, first, seenFrom))
        return ivec2(heightAt(first, 0));
    return ivec2(nowhere);
}

void main()
{
    uint ray = gl_GlobalInvocationID.x;
    if (ray >= rayCount)
        return;
    ivec3 origin = rays[ray].xyz;
    ivec2 range = samplesInside(origin, seen[ray]);
    int first = range.x;
    ivec2 run = ivec2(-1); // the last run of hollow samples so far
    for (; first < range.y; ++first) {
        ivec3 p = at(origin, first, 0);
        int empty = samplesInEmptyCell(p);
        if (empty > 0) {
            first += empty - 1;
            continue;
        }
        if (!denseHere(p))
            continue;
        if (!carvedHere(p))
            break;
        run = ivec2(run.y >= 0 && run.y == first - 1 ? run.x : first, first);
    }
    if (restore) {
        hits[ray] = hollowOf(origin, first, range.y, run, seen[ray].x);
        return;
    }
    if (first >= range.y) {
        hits[ray] = ivec2(nowhere);
        return;
    }
    int surface =
        first > seen[ray].x ? turnsAt(origin, first, false, true) : heightAt(first, 0);

    int exit = nowhere;
    int gap = 0;
    for (int n = first + 1; !throughGaps && n < seen[ray].y && heightAt(n, 0) <= surface + maxDepth;
         ++n) {
        if (materialHere(at(origin, n, 0))) {
            gap = 0;
        } else if (++gap == gapSamples) {
            exit = heightAt(n - gap + 1, 0);
            break;
        }
    }
    hits[ray] = ivec2(surface, exit);
}
