#version 330 core
out vec4 color;

void main()
{
    // A quarter: four fragments can be added up in one pixel of any format.
    color = vec4(0.25);
}
