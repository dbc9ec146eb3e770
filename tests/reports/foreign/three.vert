#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
varying vec3 vViewPosition;

void main() {
	#include <uv_vertex>
	#include <begin_vertex>
	#include <project_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <fog_vertex>
}
