// What one sprite leaves of the light; what all leave is multiplied.

in vec2 off;
flat in float depth;
out vec4 left;

void main() {
    float inside = max(1.0 - dot(off, off), 0.0);
    left = vec4(exp(-0.1 * depth * inside * sqrt(inside)));
}
