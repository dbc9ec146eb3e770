#version 330
// A game of chess under ambient occlusion by discs (Bunnell 2005), after the chess scene of
// Scherzer et al.: what stands still and the king that moves are summed separately.

in vec3 v_world;
in vec3 v_normal;
in vec2 v_uv;

uniform sampler2D u_discs;      // of the board and of the pieces that stand still
uniform sampler2D u_kingDiscs;  // of the king, as if he stood in the origin
uniform sampler2D u_wood;
uniform vec3 u_king;            // where he stands
uniform vec3 u_eye;
uniform vec3 u_light;           // towards the light, unit length

out vec4 o_color;

const float PI = 3.14159265;
const float REACH = 16.0;  // a disc stands for its parts from four times the edge of its square

// How much of the sky above a point is hidden by discs. Each row of the texture is a disc: its
// middle and area; its normal, shorter if the surface is bent, and the row that follows its parts.
// The parts, if it has any, are the rows in between.
float occlusion(sampler2D discs, vec3 point, vec3 normal) {
    int rows = textureSize(discs, 0).y;
    float covered = 0.0;
    int row = 0;
    while (row < rows) {
        vec4 disc = texelFetch(discs, ivec2(0, row), 0);
        vec4 facing = texelFetch(discs, ivec2(1, row), 0);
        vec3 way = disc.xyz - point;
        float away = dot(way, way) + 1e-4;
        int after = int(facing.w);
        if (after > row + 1 && away < REACH * disc.w) {
            row++;
            continue;
        }
        way *= inversesqrt(away);
        // What is bent shows something to every side; a ball a quarter of its surface.
        float shown = max(-dot(facing.xyz, way), 0.0) + 0.25 * (1.0 - dot(facing.xyz, facing.xyz));
        covered += shown * max(dot(normal, way), 0.0) * disc.w / (PI * away + disc.w);
        row = after;
    }
    return covered;
}

void main() {
    vec3 normal = normalize(v_normal);
    float still = occlusion(u_discs, v_world, normal);
    float king = occlusion(u_kingDiscs, v_world - u_king, normal);
    float open = exp(-(still + king));

    vec3 wood = texture(u_wood, v_uv).rgb;
    vec3 halfway = normalize(u_light + normalize(u_eye - v_world));
    float diffuse = max(dot(normal, u_light), 0.0);
    float specular = pow(max(dot(normal, halfway), 0.0), 48.0);
    vec3 color = wood * open * (0.55 + 0.75 * diffuse) + 0.35 * open * specular;
    o_color = vec4(color, 1.0);
}
