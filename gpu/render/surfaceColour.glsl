// The colours of the surface that is being refined, by its marks.

/* Uniforms */
uniform vec3 ownColour;
uniform vec4 markColours[3]; // yellow, green, red; alpha: share of markOpacity
uniform float markOpacity;

/// The mark that prevails at a place; between two marks it is one of them, not a mixture.
/// @param marks weights of yellow, green, red
int markOf(vec3 marks)
{
    const bool red = marks.z > max(marks.x, marks.y);
    return red ? 2 : marks.y > marks.x ? 1 : 0;
}

vec3 marked(vec3 colour, int mark)
{
    return mix(colour, markColours[mark].rgb, markColours[mark].a * markOpacity);
}
