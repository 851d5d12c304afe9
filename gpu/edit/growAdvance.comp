// Between two rings: what was claimed becomes the front. One invocation.

layout(local_size_x = 1) in;

layout(binding = 0, std430) buffer State {
    uint dispatchX, dispatchY, dispatchZ;
    uint frontCount;
    uint nextCount;
    uint generation;
    uint overflow;
    uint ringsDone;
    uint ringSizes[16];
} state;

uniform bool countsAsRing; // false right after the front was found

void main()
{
    uint claimed = state.nextCount;
    if (countsAsRing && claimed > 0u) {
        ++state.generation;
        state.ringSizes[state.ringsDone] = claimed;
        ++state.ringsDone;
    }
    state.frontCount = state.overflow != 0u ? 0u : claimed;
    state.nextCount = 0u;
    state.dispatchX = min((state.frontCount + 63u) / 64u, 65535u);
    state.dispatchY = 1u;
    state.dispatchZ = 1u;
}
