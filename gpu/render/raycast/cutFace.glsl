// Cut faces: matter that lies open where something is carved away, clipped, or the scan ends.

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

/// Grey values are seen without the light's tint and gloss; on a flat face as a slice shows them.
/// @param grey how much of a cut face in grey values this is @param flatFace 1: of a plane
vec4 lightOnFace(vec4 light, float grey, float flatFace)
{
    const float even = mix(dot(light.rgb, vec3(1.0 / 3.0)), 1.0, flatFace);
    return mix(light, vec4(vec3(even), 0.0), grey);
}
