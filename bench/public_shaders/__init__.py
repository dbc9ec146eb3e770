"""How many shaders that nobody here wrote the front end takes, glslang being the judge.

The shaders come from packages that are fetched by name into ``out/public/`` and never committed:

* ``three``, the sources that three.js hands to WebGL for the materials of its ShaderLib, in several
  settings, and ``three examples``, those of its post-processing shaders;
* ``gl-transitions``, each transition inside the host's prelude;
* ``piglit``, the vertex and fragment shaders of a large OpenGL test suite, right ones and wrong.
"""
