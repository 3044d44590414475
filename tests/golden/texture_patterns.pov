// golden: +W160 +H120 -A; psnr >= 50; textures that a pattern chooses, one way per ball
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -9> right 4/3*x up y angle 50 }
light_source { <-20, 30, -30> rgb 0.9 }
background { rgb <0.1, 0.15, 0.3> }
#declare A = texture { pigment { rgb <0.9, 0.3, 0.2> } normal { bumps 0.6 scale 0.1 } finish { phong 0.8 } }
#declare B = texture { pigment { bozo scale 0.1 } finish { specular 0.5 reflection 0.2 } }
#declare G = texture { pigment { rgbf <0.8, 0.9, 1, 0.8> } finish { phong 1 } }
#declare N = 0;
#macro Ball(T)
  sphere { 0, 0.85 texture { T } rotate 20*N translate <mod(N, 4) * 1.9 - 2.85, div(N, 4) * 1.9 - 1.9, 0> }
  #declare N = N + 1;
#end
Ball(texture { checker texture { A } texture { B } scale 0.5 })
Ball(texture { gradient x texture_map { [0.3 A] [0.7 B] } scale 1.2 translate -0.6*x })
Ball(texture { tiles { texture { A } tile2 texture { G } } scale 0.4 rotate 30*y })
Ball(texture { average texture_map { [2 A] [1 B] } })
Ball(texture { bozo scale 0.5 turbulence 0.4 texture_map { [0.4 A] [0.4 G] [0.6 G] [0.7 B scale 2] } })
Ball(texture { hexagon texture { A } texture { B } scale 0.4 rotate 90*x })
Ball(texture { brick texture { A } texture { B } brick_size <0.8, 0.3, 0.5> mortar 0.05 })
Ball(texture {
  gradient y
  texture_map {
    [0.3 checker texture { A } texture { pigment { rgb y } normal { wrinkles 0.9 scale 0.2 } } scale 0.3 rotate 20]
    [0.6 crackle scale 0.4 texture_map { [0.05 pigment { rgb 0 }] [0.1 B] }]
  }
  scale 1.4 rotate 20 translate 0.3
})
#declare P = texture { wood texture_map { [0.3 A] [0.5 B] } scale 0.3 }
Ball(texture { P scale 2 rotate 30*x })
Ball(texture { A pigment { gradient z pigment_map { [0 rgb 1] [1 rgb z] } } no_bump_scale })
Ball(texture { A normal { average normal_map { [1 bumps 0.5 scale 0.1] [1 dents scale 0.2] } } pigment { average pigment_map { [1 rgb x] [2 checker rgb 1 rgb 0 scale 0.2] } } })
Ball(texture { agate turbulence 0.3 texture_map { [0.3 A] [0.6 pigment { rgb 1 } finish { ambient 0.6 }] } })
