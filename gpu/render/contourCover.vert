// Draws a line of a contour as a rectangle that encloses all pixels that it may cover.

/* Attributes, one line an instance */
layout(location = 0) in vec4 ends; // frame pixels
layout(location = 1) in vec4 firstMarks;
layout(location = 2) in vec4 lastMarks;

/* Uniforms */
uniform float pixelScale; // frame pixels per drawn pixel
uniform vec2 texels;      // of the target
uniform float reach;      // drawn pixels around the line

/* Output */
layout(location = 0) flat out vec4 line; // drawn pixels
layout(location = 1) flat out vec3 marksFrom;
layout(location = 2) flat out vec3 marksTo;

void main()
{
    line = ends / pixelScale;
    marksFrom = firstMarks.xyz;
    marksTo = lastMarks.xyz;
    const vec2 along = line.zw - line.xy;
    const float apart = length(along);
    const vec2 way = apart > 1e-6 ? along / apart : vec2(1.0, 0.0);
    const vec2 across = vec2(-way.y, way.x);
    const vec2 end = (gl_VertexID & 1) == 0 ? line.xy - way * reach : line.zw + way * reach;
    const vec2 corner = end + across * ((gl_VertexID & 2) == 0 ? -reach : reach);
    gl_Position = vec4(2.0 * corner / texels - 1.0, 0.0, 1.0);
}
