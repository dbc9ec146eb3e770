// As many tiles as there are frames in a period, each due in one of them.

// The frame of each period in which the pixel's turn comes.
int sc_turn() {
    vec2 blocks = sc_blocks();
    float tile = ceil((blocks.x * blocks.y - 0.5) / float(sc_period));
    return int((float(sc_number(blocks, floor(sqrt(tile) + 0.01))) + 0.5) / tile);
}

// The picture in blocks. Numbers are divided as floats, with half of one added, so that no rounding
// can matter: many renderers divide integers slowly.
vec2 sc_blocks() {
    return floor((vec2(textureSize(sc_cache, 0) + sc_block) - 0.5) / float(sc_block));
}

// The pixel's block, numbered from 0 without gaps: strips that are `tall` blocks high, one above the
// other, and in each column after column. So neighbours in number are neighbours in the picture.
int sc_number(vec2 blocks, float tall) {
    vec2 block = floor(gl_FragCoord.xy / float(sc_block));
    float bottom = floor((block.y + 0.5) / tall) * tall;
    float column = min(tall, blocks.y - bottom);
    return int(bottom) * int(blocks.x) + int(block.x * column + block.y - bottom);
}
