// golden: +W48 +H36 -A; psnr >= 45; rows of faces as the oracle has them
#version 3.7;
global_settings { assumed_gamma 1 }
// One face for every pixel, with a bend.
#macro Grid(W, H, DX)
  #for (J, 0, H - 1) #for (I, 0, W - 1)
    #local X = 3 * (I / W - 0.5) + DX;
    #local Y = 2.2 * (0.5 - J / H);
    triangle { <X, Y, 0.1 * X * X>, <X + 0.02, Y, 0.1 * X * X - 0.004 * Y>, <X, Y - 0.02, 0.1 * X * X + 0.003 * X> }
  #end #end
#end
camera { mesh_camera { 1 1 3.6 mesh { Grid(48, 20, 0) } mesh { Grid(48, 10, 0.4) rotate y * 20 } } direction -z }
sky_sphere { pigment { checker rgb <0.9, 0.8, 0.6>, rgb <0.2, 0.4, 0.7> scale 0.17 } }
sphere { <0.4, 0.3, 3>, 0.5 pigment { rgb <0.9, 0.3, 0.2> } finish { ambient 0.4 } }
sphere { <-0.7, -0.4, 4>, 0.6 pigment { rgbf <0.4, 0.9, 0.5, 0.6> } finish { ambient 0.4 } }
light_source { <1, 6, -3> rgb 1 }
