"""Bad, odd and huge input for the front end: it takes it, or says what is wrong, in linear time."""
