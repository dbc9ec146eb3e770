#version 330
uniform float u_a;
out vec4 color;

//// Each trip is a block.
void main() {
    float a = u_a;
    for (int i = 0; i < 2; i++)
        a += float(i) * u_a;
    color = vec4(a);
}
//// becomes
#version 330

uniform float u_a;
out vec4 color;

void main() {
    float a = u_a;
    {
        int i = 0;
        a += float(i) * u_a;
    }
    {
        int i = 1;
        a += float(i) * u_a;
    }
    color = vec4(a);
}

//// Loops in loops.
void main() {
    float a = u_a;
    for (int i = 0; i < 2; i++)
        for (int j = i; j < 2; j++)
            a += float(i - j);
    color = vec4(a);
}
//// becomes
#version 330

uniform float u_a;
out vec4 color;

void main() {
    float a = u_a;
    {
        int i = 0;
        {
            int j = 0;
            a += float(i - j);
        }
        {
            int j = 1;
            a += float(i - j);
        }
    }
    {
        int i = 1;
        {
            int j = 1;
            a += float(i - j);
        }
    }
    color = vec4(a);
}

//// Conditions on counters are decided.
void main() {
    float a = u_a;
    for (int i = 0; i < 9; i++) {
        if (i == 1)
            continue;
        if (i > 3) {
            a *= 2.0;
            break;
        }
        a += float(i);
    }
    color = vec4(a);
}
//// becomes
#version 330

uniform float u_a;
out vec4 color;

void main() {
    float a = u_a;
    {
        int i = 0;
        a += float(i);
    }
    {
        int i = 1;
    }
    {
        int i = 2;
        a += float(i);
    }
    {
        int i = 3;
        a += float(i);
    }
    {
        int i = 4;
        {
            a *= 2.0;
        }
    }
    color = vec4(a);
}

//// Counters of several types.
void main() {
    float a = u_a;
    for (uint i = 2u; i > 0u; i--)
        a += float(i);
    for (float t = 0.0; t < 0.3; t += 0.1)
        a += t;
    for (int i = -1, j = 1; i < j; i++, j -= 1)
        a += float(j);
    color = vec4(a);
}
//// becomes
#version 330

uniform float u_a;
out vec4 color;

void main() {
    float a = u_a;
    {
        uint i = 2u;
        a += float(i);
    }
    {
        uint i = 1u;
        a += float(i);
    }
    {
        float t = 0.0;
        a += t;
    }
    {
        float t = 0.1;
        a += t;
    }
    {
        float t = 0.2;
        a += t;
    }
    {
        int i = -1;
        int j = 1;
        a += float(j);
    }
    color = vec4(a);
}

//// A loop that takes the fragment to decide stays.
void main() {
    float a = u_a;
    for (int i = 0; i < int(u_a); i++)
        a += 1.0;
    for (int i = 0; i < 3; i++) {
        if (a > 1.0)
            break;
        a += 1.0;
    }
    color = vec4(a);
}
//// becomes
#version 330

uniform float u_a;
out vec4 color;

void main() {
    float a = u_a;
    for (int i = 0; i < int(u_a); i++)
        a += 1.0;
    for (int i = 0; i < 3; i++) {
        if (a > 1.0)
            break;
        a += 1.0;
    }
    color = vec4(a);
}

//// A loop under a condition, and one that makes no trip inside another.
void main() {
    float a = u_a;
    if (a > 0.0)
        for (int i = 0; i < 1; i++)
            a += 1.0;
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < i; j++)
            a += 1.0;
    color = vec4(a);
}
//// becomes
#version 330

uniform float u_a;
out vec4 color;

void main() {
    float a = u_a;
    if (a > 0.0) {
        {
            int i = 0;
            a += 1.0;
        }
    }
    {
        int i = 0;
    }
    {
        int i = 1;
        {
            int j = 0;
            a += 1.0;
        }
    }
    color = vec4(a);
}
