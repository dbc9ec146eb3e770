# Writes the vertex and fragment shaders that stand in sections of piglit's tests beside them, as
# x.shader_test.vert and x.shader_test.2.frag. One without #version has that which the test requires.

function flush_section() {
    if (stage != "") {
        number = ++seen[stage]
        path = test (number > 1 ? "." number : "") "." stage
        printf "%s%s", (text ~ /#version/ ? "" : version), text > path
        close(path)
    }
    stage = text = ""
}

FNR == 1 {
    flush_section()
    test = FILENAME
    version = "#version 110\n"
    split("", seen)
}

/^GLSL( ES)? >= [0-9]+\.[0-9]+/ {
    es = $2 == "ES"
    split($NF, parts, ".")
    number = parts[1] * 100 + substr(parts[2] "0", 1, 2)
    version = "#version " number (es && number > 100 ? " es" : "") "\n"
}

/^\[/ {
    flush_section()
    stage = /^\[vertex shader\]/ ? "vert" : /^\[fragment shader\]/ ? "frag" : ""
    next
}

{ text = text $0 "\n" }

END { flush_section() }
