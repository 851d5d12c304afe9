// Transforms a vertex of the surface that is being refined by the ray caster's camera.

/* Attributes */
layout(location = 0) in vec3 position; // world
layout(location = 1) in vec4 normal;   // world
layout(location = 2) in vec4 marks;    // yellow, green, red; 1 in a face's middle, 0 on its rim

/* Uniforms */
uniform mat4 clipFromView; // from millimetres to the right, down and away from the target
uniform vec3 viewRight;    // world, unit
uniform vec3 viewDown;
uniform vec3 viewForward;
uniform vec3 viewTarget; // world

/* Output */
layout(location = 0) out vec3 fromTarget; // world
layout(location = 1) out vec3 outwards;
layout(location = 2) out vec4 placeMarks;

void main()
{
    fromTarget = position - viewTarget;
    outwards = normal.xyz;
    placeMarks = marks;
    const vec3 inView = vec3(
        dot(fromTarget, viewRight), dot(fromTarget, viewDown), dot(fromTarget, viewForward));
    gl_Position = clipFromView * vec4(inView, 1.0);
}
