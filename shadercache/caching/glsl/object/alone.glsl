// Each draw is of one object.

uniform int sc_object;           // number of the object that is drawn
