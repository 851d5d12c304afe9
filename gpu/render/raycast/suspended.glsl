// What another interval has suspended (gpu/kernels/shrink/PreviewMarks) as translucent bodies
// beside the segment, striped as in slices. Those behind tissue shine through faintly. Include
// render/parts/cutPreview.glsl and render/raycast/bodies.glsl before this file.

/* Uniforms */
uniform vec3 suspendedLow; // index: low corner of a box around all that is suspended
uniform vec3 suspendedHigh;

const float suspendedOpacity = 0.6;
const float suspendedBehind = 0.25;

/// Adds what is suspended to what is seen: in front of it, and behind it faintly.
vec3 withSuspended(Ray ray, vec3 seen)
{
    const MetBody met = bodyAlong(ray, suspendedBody, suspendedLow, suspendedHigh);
    const vec3 own
        = previewMarkColour(growthSuspended, gl_FragCoord.xy * pixelScale, suspendedColour);
    const vec3 look = lit(own, lightOn(met.normal, -ray.world, 1.0, 0.15));
    return mix(seen, look, met.found ? (met.hidden ? suspendedBehind : suspendedOpacity) : 0.0);
}
