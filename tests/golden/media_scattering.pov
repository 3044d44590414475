// golden: +W64 +H48 -A; psnr >= 60; exact: all phase functions, extinction and eccentricity
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z right 8*x up 6*y }
light_source { <-6, 4, -9>, <0.5, 0.45, 0.4> }
light_source { <2, -3, 12>, <0.4, 0.5, 0.6> }
#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
#macro Ball(M, P) sphere { P, 0.9 texture { Clear } hollow interior { media { M } } } #end
Ball(media { scattering { 1, 0.3 } }, <-2.5, 1.5, 0>)
Ball(media { scattering { 2, 0.3 } }, <0, 1.5, 0>)
Ball(media { scattering { 3, 0.3 } }, <2.5, 1.5, 0>)
Ball(media { scattering { 4, 0.3 } }, <-2.5, -1.5, 0>)
Ball(media { scattering { 5, <0.4, 0.3, 0.2> eccentricity 0.4 } }, <0, -1.5, 0>)
Ball(media { scattering { 5, 0.3 eccentricity -0.4 extinction 0 } absorption <0, 0, 0.5> }, <2.5, -1.5, 0>)
