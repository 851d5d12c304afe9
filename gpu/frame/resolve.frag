// Divides the sum of pictures by their number; enlarges a coarse picture bilinearly.

/* Textures */
layout(binding = 0) uniform sampler2D sum;

/* Uniforms */
uniform float scale;
uniform vec2 drawnPerFrame; // drawn pixels per frame pixel
uniform vec2 drawn;         // drawn pixels

/* Output */
layout(location = 0) out vec4 colour;

void main()
{
    const vec2 at = clamp(gl_FragCoord.xy * drawnPerFrame, vec2(0.5), drawn - 0.5);
    colour = vec4(texture(sum, at / vec2(textureSize(sum, 0))).rgb * scale, 1.0);
}
