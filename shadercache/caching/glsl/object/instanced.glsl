// Each draw is of several instances, which are told apart like objects.

flat in int sc_object;           // number of the instance that is drawn: the vertex shader counts on
