// Barriers (voxels closed to growth) as translucent bodies. Those behind tissue shine through
// faintly. Include render/raycast/bodies.glsl before this file.

/* Uniforms */
uniform vec3 barrierLow; // index: low corner of the box around all barriers
uniform vec3 barrierHigh;

const vec3 barrierColour = vec3(0.93, 0.25, 0.36); // as in slices
const float barrierOpacity = 0.6;
const float barrierBehind = 0.2;

/// Adds the barriers to what is seen: those in front of it, and those behind it faintly.
vec3 withBarriers(Ray ray, vec3 seen)
{
    const MetBody met = bodyAlong(ray, barrierBody, barrierLow, barrierHigh);
    const vec3 look = lit(barrierColour, lightOn(met.normal, -ray.world, 1.0, 0.15));
    return mix(seen, look, met.found ? (met.hidden ? barrierBehind : barrierOpacity) : 0.0);
}
