#version 330 core
struct Material { sampler2D diffuse; sampler2D specular; float shininess; };
struct DirLight { vec3 direction; vec3 ambient; vec3 diffuse; vec3 specular; };
struct PointLight {
    vec3 position;
    float constant;
    float linear;
    float quadratic;
    vec3 ambient;
    vec3 diffuse;
    vec3 specular;
};

in VS_OUT {
    vec3 FragPos;
    vec3 Normal;
    vec2 TexCoords;
} fs_in;

uniform vec3 viewPos;
uniform DirLight dirLight;
uniform PointLight pointLights[3];
uniform Material material;

out vec4 FragColor;

vec3 lit(vec3 normal, vec3 to_light, vec3 to_eye, vec3 diffuse, vec3 specular) {
    vec3 middle = normalize(to_light + to_eye);
    float gloss = pow(max(dot(normal, middle), 0.0), material.shininess);
    vec3 albedo = texture(material.diffuse, fs_in.TexCoords).rgb;
    vec3 shine = texture(material.specular, fs_in.TexCoords).rgb;
    return max(dot(normal, to_light), 0.0) * diffuse * albedo + gloss * specular * shine;
}

void main() {
    vec3 normal = normalize(fs_in.Normal);
    vec3 to_eye = normalize(viewPos - fs_in.FragPos);
    vec3 sum = dirLight.ambient * 0.2
        + lit(normal, normalize(-dirLight.direction), to_eye, dirLight.diffuse, dirLight.specular) * 0.3;
    for (int i = 0; i < 3; ++i) {
        vec3 way = pointLights[i].position - fs_in.FragPos;
        float far = length(way);
        float fades = 1.0 / (pointLights[i].constant + pointLights[i].linear * far
            + pointLights[i].quadratic * far * far);
        vec3 light = lit(normal, way / far, to_eye, pointLights[i].diffuse, pointLights[i].specular);
        sum += fades * 0.3 * (pointLights[i].ambient + light);
    }
    FragColor = vec4(sum, 1.0);
}
