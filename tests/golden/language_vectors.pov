// golden: +W96 +H72 -A; psnr >= 50; the same objects must come out, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0.013, 0.007, -10> look_at <0.013, 0.007, 0> right 8*x up 6*y }  // off the grid: no pixel on an edge
light_source { <-6, 8, -12> rgb 1 }
background { rgb <0.2, 0.25, 0.35> }
#default { finish { ambient 0.25 } }
// Components, mixed arithmetic, promotion of a float, and vector functions placing balls.
#declare A = <1, 0.5, 0>;
#declare C = A*2 - 0.5;
#macro Ball(P, R, T) sphere { P, R pigment { rgb T } } #end
Ball(A, 0.3, <0.9, 0.3, 0.2>)
Ball(C, 0.25, <0.9, 0.6, 0.2>)
Ball(-A + y*1.5, 0.3, <0.4, 0.8, 0.3>)
Ball(<A.y*2, A.x, 0> - 3*x, 0.3, <0.3, 0.6, 0.9>)
Ball(vrotate(2*x, <0, 0, 210>), 0.35, <0.7, 0.3, 0.8>)
Ball(vnormalize(<2, -3, 0>)*2.5, 0.3, <0.8, 0.8, 0.3>)
Ball(vcross(<0, 0, 1>, <1.5, 2, 0>), 0.3, <0.3, 0.8, 0.8>)
Ball(vaxis_rotate(2.4*x, z, -40), 0.3, <0.8, 0.5, 0.5>)
Ball(<3, 2> + <0.2, 0.1>, 0.3, <0.6, 0.9, 0.6>)
Ball(A/<2, 4, 1> - <3, 2, 0>, 0.3, C.x*<0.5, 0.4, 0.3>)
cylinder { min(A.x, C.x)*x - 2.6*y, max(A.x, 2)*x - 2.6*y, 0.15 pigment { rgb 0.8 } }
