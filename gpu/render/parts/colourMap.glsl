// In which colour a grey value (0 … 1) is shown.

layout(binding = 29) uniform sampler2D colourMap; // 256 × 1, by grey value
uniform bool coloured; // false: grey

vec3 shownGrey(float grey)
{
    return coloured ? texelFetch(colourMap, ivec2(int(grey * 255.0 + 0.5), 0), 0).rgb : vec3(grey);
}
