// Rooms of several labels lie in one paged field whose grid of bricks is that of the volume, many
// times over in y and z: a place a label. To be included after `volumeBricks`.

layout(binding = 2) uniform usampler3D roomPages;
uniform uint slotsAcross; // along y

ivec3 slotBrick(ivec3 brick, uint slot)
{
    return brick
        + ivec3(0, int(slot % slotsAcross) * volumeBricks.y, int(slot / slotsAcross) * volumeBricks.z);
}
