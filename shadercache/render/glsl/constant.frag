#version 330 core
out highp vec4 color;  // GLSL ES wants the precision

void main()
{
    // A quarter: four fragments can be added up in one pixel of any format.
    color = vec4(0.25);
}
