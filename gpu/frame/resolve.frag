// Divides the sum of pictures by their number. ENLARGED: of a coarse picture, which is enlarged
// bilinearly; else each pixel has its own sum, and reading four of them would cost a software driver
// as much as everything else here.

/* Textures */
layout(binding = 0) uniform sampler2D sum;

/* Uniforms */
uniform float scale;
#if ENLARGED
uniform vec2 drawnPerFrame; // drawn pixels per frame pixel
uniform vec2 drawn;         // drawn pixels
#endif

/* Output */
layout(location = 0) out vec4 colour;

void main()
{
#if ENLARGED
    const vec2 at = clamp(gl_FragCoord.xy * drawnPerFrame, vec2(0.5), drawn - 0.5);
    const vec3 summed = texture(sum, at / vec2(textureSize(sum, 0))).rgb;
#else
    const vec3 summed = texelFetch(sum, ivec2(gl_FragCoord.xy), 0).rgb;
#endif
    colour = vec4(summed * scale, 1.0);
}
