// golden: +W96 +H72 -A; psnr >= 50; the same objects must come out, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }
// The language asks objects: where does a ray end, is a point inside, how large is it.
camera { location <0, 3, -6> look_at <0, 0, 0> angle 46 }
light_source { <-4, 6, -6> rgb 1 }
#declare Body = difference { torus { 1.2, 0.5 } box { <0, -1, -2>, <2, 1, 0> } rotate 20*x }
object { Body pigment { rgb <0.5, 0.6, 0.8> } }
#for (A, 0, 350, 15)
  #local From = vrotate(<1.2, 3, 0>, A*y);
  #local N = <0, 0, 0>;
  #local P = trace(Body, From, -y, N);
  #if (vlength(N) > 0) cylinder { P, P + 0.4*N, 0.05 pigment { rgb <0.9, 0.5, 0.2> } } #end
#end
#for (I, -8, 8) #if (inside(Body, <I*0.25, 0, 0.3>)) sphere { <I*0.25, 1.2, 0.3>, 0.1 pigment { rgb <0.9, 0.9, 0.3> } } #end #end
box { min_extent(Body) - <0, 0.3, 0>, max_extent(Body)*<1, 0, 1> - <0, 1.3, 0> pigment { rgb <0.4, 0.6, 0.4> } }
