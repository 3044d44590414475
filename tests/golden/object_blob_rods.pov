// golden: +W96 +H64 -A; psnr >= 42; roots by another solver
#version 3.7;
global_settings { assumed_gamma 1 }
// Long rods with caps far from their middles; components that are turned, stretched, slanted.
camera { location <0.3, 3, -9> look_at <0, 0.4, 0> angle 48 }
light_source { <-4, 9, -7> rgb 1 }
#default { finish { ambient 0.15 phong 0.4 } }
blob { threshold 0.25 cylinder { -1.6*y, 1.6*y, 0.7, 1 } pigment { rgb <0.9, 0.6, 0.2> } translate <-2.8, 1, 0> }
blob { threshold 0.3 cylinder { <-1.6, -0.4, 0>, <1.2, 1.6, 1>, 0.5, 1 rotate 20*z } pigment { rgb <0.3, 0.6, 0.9> } }
blob { threshold 0.3 cylinder { -x, x, 0.4, 1 scale <1, 2, 1> rotate 40*z } pigment { rgb <0.5, 0.8, 0.4> } scale <1, 1.3, 1> rotate 30*y translate <2.4, 0.6, 0> }
blob { threshold 0.2
  sphere { x, 0.8, 1 rotate 70*z scale 1.2 translate <0.4, -0.8, -1> }
  sphere { 0, 1, 1 rotate 30*z scale <1.2, 0.4, 0.7> matrix <1, 0.3, 0, 0.2, 1, 0, 0, 0, 1, 0, -0.8, -1.2> }
  pigment { rgb <0.9, 0.4, 0.6> } }
merge {
  intersection { blob { threshold 0.25 cylinder { -1.4*y, 1.4*y, 0.5, 1 } } plane { -y, 0.2 } }
  sphere { 0.2*y, 0.4 }
  pigment { rgb <0.8, 0.8, 0.3> } rotate -20*z translate <-1, -0.5, -1.5>
}
