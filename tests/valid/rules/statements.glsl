//// 6.2 the condition of an if is bool | SC212
if (u_i) { }
//// 6.2 the condition of an if is a scalar | SC212
if (bvec2(true)) { }
//// 6.2 both branches are checked | SC201 SC201
if (true) { one = 1; } else { two = 2; }
//// 6.3 the conditions of loops are bool | SC212 SC212 SC212
for (int i = 0; i; ++i) { }
while (u_f) { }
do { } while (1);
//// 6.3 a condition may declare a variable | ok
while (bool go = u_f > 1.0) { if (go) break; }
for (int i = 0; bool go = i < 3; ++i) { if (go) continue; }
//// 6.3 that variable is bool | SC212
while (float x = 1.0) { }
//// 6.3 all parts of a loop may be empty | ok
for (;;) { break; }
//// 6.4 break is in a loop or switch | SC218
break;
//// 6.4 continue is in a loop | SC218
continue;
//// 6.4 continue is not in a switch alone | SC218
switch (u_i) { case 0: continue; }
//// 6.4 continue in a switch in a loop | ok
for (int i = 0; i < 2; ++i) { switch (i) { case 0: continue; default: break; } }
//// 6.4 a jump after the loop | SC218
for (int i = 0; i < 2; ++i) { }
break;
//// 6.4 discard in a fragment shader | ok
if (u_f > 0.0) discard;
//// 6.4 discard in a vertex shader | SC218 [vertex]
void main() { discard; }
//// 6.4 return in main | ok
if (u_f > 0.0) return;
o_color = vec4(1.0);
//// 6.2 switch | ok
switch (u_i) { case 0: case K: o_color = vec4(0.0); break; case -1: { break; } default: o_color = vec4(1.0); }
//// 6.2 the selector is an integer | SC220
switch (u_f) { case 0: break; }
//// 6.2 labels are constant | SC220
switch (u_i) { case u_i: break; }
//// 6.2 labels are integers | SC220
switch (u_i) { case 1.0: break; }
//// 6.2 a label twice | SC220
switch (u_i) { case 3: break; case K: break; }
//// 6.2 default twice | SC220
switch (u_i) { default: break; default: break; }
//// 6.2 a statement before the first label | SC220
switch (u_i) { o_color = vec4(0.0); case 0: break; }
//// 6.2 a label at the end | SC220
switch (u_i) { case 0: break; case 1: }
//// 6.2 a label outside of a switch | SC103
case 0: ;
//// 6.2 a label in a block of a switch | SC103
switch (u_i) { case 0: { case 1: break; } }
//// 6.2 a label of another integer type | ok
uint u = uint(u_i);
switch (u) { case 0: break; }
//// 6.2 labels of one type | ok
uint u = uint(u_i);
switch (u) { case 0u: break; case 1u: break; }
//// 6.2 a switch is one scope | SC202
switch (u_i) { case 0: int a = 1; break; case 1: int a = 2; break; }
//// 6 nested functions are not known; a prototype in a function is | ok
float late(float x);
void main() { float late2(float x); float y = late(1.0) + late2(1.0); }
float late(float x) { return x; }
float late2(float x) { return x; }
//// 6 statements without effect | ok
1.0;
u_f + 1.0;
;
{ }
