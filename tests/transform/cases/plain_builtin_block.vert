//// A built-in block with an instance name.
#version 450
in vec4 a_position;
out gl_PerVertex {
    vec4 gl_Position;
} self;
void main() {
    self.gl_Position = a_position;
}
//// becomes
#version 450

in vec4 a_position;

out gl_PerVertex {
    vec4 gl_Position;
};

void main() {
    gl_Position = a_position;
}
