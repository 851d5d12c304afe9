// The word of the seed map; core/growth/SeedWord.h says what the bits mean.

const uint unvisited = 0xFFFFFFFFu;
const uint notMember = 0x80000000u;
const uint seedDirection = 31u;

const ivec3 faceOffsets[6] = ivec3[6](ivec3(1, 0, 0), ivec3(-1, 0, 0), ivec3(0, 1, 0),
    ivec3(0, -1, 0), ivec3(0, 0, 1), ivec3(0, 0, -1));

uint memberWord(uint generation, uint label, uint direction)
{
    return generation << 13 | label << 5 | direction;
}

uint pendingSeedWord(uint label)
{
    return notMember | label << 5 | seedDirection;
}

bool isMember(uint word)
{
    return (word & notMember) == 0u;
}

bool isPendingSeed(uint word)
{
    return word != unvisited && !isMember(word) && (word & 31u) == seedDirection;
}

uint labelOf(uint word)
{
    return word >> 5 & 0xFFu;
}

uint generationOf(uint word)
{
    return word >> 13 & 0x3FFFFu;
}
