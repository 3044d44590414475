// bench: +W320 +H240 -A; marble, wax and skin: light below surfaces
#version 3.7;
global_settings { assumed_gamma 1 mm_per_unit 20 subsurface { samples 100, 20 } }
camera { location <0, 3, -6> look_at <0, 0.7, 0> angle 42 }
light_source { <-5, 7, -3>, 0.9 }
light_source { <4, 3, 4>, <0.4, 0.45, 0.6> }
background { rgb <0.1, 0.12, 0.15> }
#default { finish { ambient 0 } }
#declare Marble =
texture {
  pigment {
    agate
    color_map { [0.4 rgb <0.83, 0.79, 0.75>] [0.9 rgb <0.6, 0.57, 0.55>] [1 rgb <0.5, 0.4, 0.35>] }
    scale 0.5
  }
  finish { diffuse 0.9 specular 0.5 reflection { 0.02, 0.3 } subsurface { translucency <0.46, 0.38, 0.33> * 4 } }
}
plane { y, 0 texture { Marble } interior { ior 1.5 } }
difference {
  box { -1, 1 }
  cylinder { -2*z, 2*z, 0.5 }
  scale 0.7 rotate 30*y translate <-1.4, 0.72, 0.5>
  texture { Marble } interior { ior 1.5 }
}
blob {
  threshold 0.5
  cylinder { 0, 1.6*y, 0.8, 1 }
  sphere { <0, 2, 0>, 0.6, -1.5 }
  sphere { <0.4, 0.4, -0.3>, 0.4, 0.6 }
  translate 0.1*x
  pigment { rgb <0.85, 0.55, 0.1> }
  finish { diffuse 0.7 specular 0.6 roughness 0.1 subsurface { translucency <5, 3, 1> } }
  interior { ior 1.45 }
}
sphere {
  <1.6, 0.7, 0.2>, 0.7
  pigment { rgb <0.9, 0.7, 0.6> }
  finish { diffuse 0.8 specular 0.3 subsurface { translucency <1.3, 0.9, 0.6> } }
  interior { ior 1.3 }
}
