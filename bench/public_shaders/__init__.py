"""How many shaders that nobody here wrote the front end gets right, glslang being the judge.

Some come from packages that ``fetch.sh`` fetches by name into ``out/public/``, never committed:

* ``three``, the sources that three.js hands to WebGL for the materials of its ShaderLib, in several
  settings, and ``three examples``, those of its post-processing shaders;
* ``gl-transitions``, each transition inside the host's prelude;
* ``piglit``, the vertex and fragment shaders of a large OpenGL test suite, right ones and wrong;

others from folders (``--shaders``). ``docs/use/acceptance.md`` says what is measured.
"""
