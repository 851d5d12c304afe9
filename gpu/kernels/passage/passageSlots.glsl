// The rooms of several labels lie in one paged field. Its grid of bricks repeats the volume's grid
// along y and z, once for each label. Include this file after `volumeBricks`.

layout(binding = 2) uniform usampler3D roomPages;
uniform uint slotsAcross; // along y

ivec3 slotBrick(ivec3 brick, uint slot)
{
    return brick
        + ivec3(0, int(slot % slotsAcross) * volumeBricks.y, int(slot / slotsAcross) * volumeBricks.z);
}
