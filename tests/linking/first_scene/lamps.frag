#version 330 core
struct Material {
    sampler2D diffuse;
    sampler2D specular;
    float shininess;
};

struct Lamp {
    vec3 position;
    vec3 color;
};

in Surface {
    vec3 place;
    vec3 normal;
    vec2 uv;
} from_vertex;

uniform Material material;
uniform Lamp lamps[2];
uniform sampler2D stains[2];
uniform sampler3D dust;
uniform usampler2D cells;
uniform vec3 viewPos;

out vec4 color;

vec3 lit(Lamp lamp) {
    vec3 normal = normalize(from_vertex.normal);
    vec3 to_lamp = normalize(lamp.position - from_vertex.place);
    vec3 to_eye = normalize(viewPos - from_vertex.place);
    float gloss = pow(max(dot(reflect(-to_lamp, normal), to_eye), 0.0), material.shininess);
    vec3 diffuse = max(dot(normal, to_lamp), 0.0) * texture(material.diffuse, from_vertex.uv).rgb;
    return lamp.color * (diffuse + gloss * texture(material.specular, from_vertex.uv).rgb);
}

void main() {
    vec3 sum = lit(lamps[0]) + lit(lamps[1]);
    sum *= texture(stains[0], from_vertex.uv).rgb + texture(stains[1], from_vertex.uv).rgb;
    sum += texture(dust, from_vertex.place).rgb;
    sum += vec3(texture(cells, from_vertex.uv).rgb) / 255.0;
    color = vec4(sum, 1.0);
}
