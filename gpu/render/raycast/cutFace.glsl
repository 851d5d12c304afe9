// Cut faces: matter that is exposed where something is carved away or clipped, or where the scan
// ends.

/* Uniforms */
uniform float greyFaces; // 1: grey values as in a slice; 0: the colour of the material
uniform vec2 faceWindow; // grey = code / 65535 · x + y
uniform vec2 lookup;     // entry of the transfer function = code / 65535 · x + y

vec3 faceGrey(float code)
{
    return vec3(clamp(code * faceWindow.x + faceWindow.y, 0.0, 1.0));
}

vec4 transferAt(float code)
{
    const float entry = code * lookup.x + lookup.y;
    const float lastEntry = float(textureSize(transferFunction, 0).x - 1);
    return texelFetch(transferFunction, ivec2(clamp(entry, 0.0, lastEntry), 0), 0);
}

/// Grey values are shown without the light's tint and gloss; on a flat face exactly as in a slice.
/// @param grey how much of this is a cut face with grey values
/// @param flatFace 1: the face of a plane
vec4 lightOnFace(vec4 light, float grey, float flatFace)
{
    const float even = mix(dot(light.rgb, vec3(1.0 / 3.0)), 1.0, flatFace);
    return mix(light, vec4(vec3(even), 0.0), grey);
}
