// The lighting of everything solid.

/* Uniforms */
uniform vec3 toLight; // world, unit
uniform vec3 viewUp;  // world, unit

/// A soft headlight from above the viewer's shoulder, sky light and a little gloss. Returns the
/// factor for an albedo (rgb) and what is added (a).
/// @param open 0: enclosed … 1: nothing near
vec4 lightOn(vec3 normal, vec3 toViewer, float open, float gloss)
{
    const float wrapped = clamp((dot(normal, toLight) + 0.35) / 1.35, 0.0, 1.0);
    const float sky = 0.5 + 0.5 * dot(normal, viewUp);
    // Shadows become warmer, not grey.
    const vec3 ambient = mix(vec3(0.20, 0.16, 0.14), vec3(0.36, 0.36, 0.38), sky);
    const vec3 shadow = mix(vec3(0.62, 0.50, 0.42), vec3(1.0), open);
    const float facingViewer = clamp(dot(normal, toViewer), 0.0, 1.0);
    const float edge = 0.72 + 0.28 * facingViewer * (2.0 - facingViewer);
    const float straight = max(dot(normal, normalize(toLight + toViewer)), 0.0);
    const float to2 = straight * straight;
    const float to8 = to2 * to2 * to2 * to2;
    const float shine = to8 * to8 * to8 * gloss * open;
    const float diffuse = wrapped * (0.75 + 0.25 * wrapped);
    return vec4((ambient + vec3(0.80, 0.785, 0.76) * diffuse) * edge * shadow, shine);
}

vec3 lit(vec3 albedo, vec4 light)
{
    return albedo * light.rgb + light.a;
}
