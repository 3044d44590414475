// bench: +W8 +H6 -A; (d) a literal mesh2 of 30 MB in an include file
// input: literal_mesh.inc
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -4> look_at 0 angle 40 }
light_source { <-4, 6, -6> rgb 1 }
#include "literal_mesh.inc"
