// golden: +W64 +H48 -A; psnr >= 60; exact: densities multiply; maps, lists, averages and names
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z right 4*x up 3*y }
#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
plane { z, 3 inverse pigment { checker rgb 1, rgb 0.3 translate 0.5*x } finish { ambient 1 diffuse 0 } hollow }
#declare Spots = density { bozo scale 0.3 color_map { [0.4 rgb 0] [0.6 rgb <1, 0.5, 0.2>] } }
#declare Fill = media { absorption 1 density { Spots } }
#macro Ball(P, M) sphere { 0, 0.7 texture { Clear } hollow interior { media { M } } translate P } #end
Ball(<-1.2, 0.7, 0>, media { Fill density { spherical } absorption 3 })
Ball(<0, 0.7, 0>, media { absorption 2 density { spherical density_map { [0 rgb 0] [0.4 Spots scale 0.5] [1 rgb 1] } } })
Ball(<1.2, 0.7, 0>, media { absorption 2 density { average density_map { [1 gradient x] [2 Spots] } } })
Ball(<-1.2, -0.7, 0>, media { absorption 2 density { checker density { rgb 1 } density { Spots } scale 0.4 } })
Ball(<0, -0.7, 0>, media { emission 0.5 absorption 1 density { bozo scale 0.5 } density { gradient y } })
Ball(<1.2, -0.7, 0>, media { absorption 1 density { } density { rgb 1 } })
