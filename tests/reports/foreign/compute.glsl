#[compute]
#version 450

layout(local_size_x = 8, local_size_y = 8, local_size_z = 1) in;
layout(rgba16f, set = 0, binding = 0) uniform image2D color_image;

void main() {
	ivec2 at = ivec2(gl_GlobalInvocationID.xy);
	vec4 color = imageLoad(color_image, at);
	imageStore(color_image, at, vec4(dot(color.rgb, vec3(0.3, 0.6, 0.1))));
}
