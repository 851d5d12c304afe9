// The words of the seed map; core/growth/SeedWord.h defines their bits.

const uint unvisited = 0xFFFFFFFFu;
const uint notMember = 0x80000000u;
const uint barrierWord = 0u; // barrier() is a function
const uint seedDirection = 31u;
const uint heldSeedDirection = 30u;
const uint heldDirection = 29u;

const ivec3 neighbourOffsets[26] = ivec3[26](ivec3(1, 0, 0), ivec3(-1, 0, 0), ivec3(0, 1, 0),
    ivec3(0, -1, 0), ivec3(0, 0, 1), ivec3(0, 0, -1), ivec3(1, 1, 0), ivec3(-1, -1, 0),
    ivec3(1, -1, 0), ivec3(-1, 1, 0), ivec3(1, 0, 1), ivec3(-1, 0, -1), ivec3(1, 0, -1),
    ivec3(-1, 0, 1), ivec3(0, 1, 1), ivec3(0, -1, -1), ivec3(0, 1, -1), ivec3(0, -1, 1),
    ivec3(1, 1, 1), ivec3(-1, -1, -1), ivec3(1, 1, -1), ivec3(-1, -1, 1), ivec3(1, -1, 1),
    ivec3(-1, 1, -1), ivec3(-1, 1, 1), ivec3(1, -1, -1));

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
    return (word & notMember) == 0u && word != barrierWord;
}

bool isPendingSeed(uint word)
{
    return word != unvisited && (word & notMember) != 0u && (word & 31u) == seedDirection;
}

uint labelOf(uint word)
{
    return word >> 5 & 0xFFu;
}

// Whether a member is a seed.
bool isSeed(uint word)
{
    return (word & 31u) >= heldSeedDirection;
}

uint generationOf(uint word)
{
    return word >> 13 & 0x3FFFFu;
}

// Whether a member was there before any growth, for instance painted.
bool isPainted(uint word)
{
    return isMember(word) && generationOf(word) == 0u;
}

// Whether a growth of the label starts from this voxel.
bool isSeedOf(uint word, uint label)
{
    if (labelOf(word) != label)
        return false;
    return isPendingSeed(word) || (isMember(word) && (isSeed(word) || generationOf(word) == 0u));
}
