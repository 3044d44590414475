// golden: +W160 +H120 -A; psnr >= 50; every kind of bumps, one per ball
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <4, 3, -10> direction z right 8*x up 6*y }
light_source { <-20, 30, -30> rgb 0.8 }
light_source { <30, -5, -20> rgb <0.2, 0.1, 0.3> shadowless }
#default { finish { ambient 0.1 diffuse 0.7 specular 0.4 roughness 0.02 } }
#declare N = 0;
#macro Ball(B)
  sphere {
    0, 0.48
    pigment { rgb <0.8, 0.7, 0.5> }
    normal { B }
    translate <mod(N, 8) + 0.5, div(N, 8) + 0.5, 0>
  }
  #declare N = N + 1;
#end
#declare S = 0.12;
Ball(normal { bumps 0.6 scale S })
Ball(normal { bumps scale S turbulence 0.5 rotate <20, 30, 40> })
Ball(normal { bumps 2 scale <S, 3*S, S> rotate 30*z })
Ball(normal { dents 1.5 scale S })
Ball(normal { dents 1.5 scale S noise_generator 1 })
Ball(normal { wrinkles 0.7 scale 3*S })
Ball(normal { ripples 0.6 frequency 12 })
Ball(normal { ripples 0.6 scale 0.1 phase 0.3 turbulence 0.2 })
Ball(normal { waves 0.5 frequency 8 scale 0.5 })
Ball(normal { waves 0.5 scale 0.1 phase 0.4 translate 2 })
Ball(normal { quilted 0.8 scale 2*S })
Ball(normal { quilted 0.8 control0 0.2 control1 0.4 scale 2*S rotate 20 })
Ball(normal { facets coords 0.6 scale 0.1 })
Ball(normal { facets size 0.5 })
Ball(normal { facets size 0.7 metric 1 })
Ball(normal { facets coords 0.4 size 0.3 metric 3 scale 0.3 })
Ball(normal { spotted 0.6 scale S })
Ball(normal { bozo -0.6 scale S })
Ball(normal { granite 0.3 scale 0.6 })
Ball(normal { agate 0.3 scale 0.3 accuracy 0.01 })
Ball(normal { marble 0.5 scale S turbulence 0.6 })
Ball(normal { wood 0.4 scale S bump_size 0.8 })
Ball(normal { crackle 0.7 scale 0.3 })
Ball(normal { leopard 0.5 scale 0.05 })
Ball(normal { gradient x, 0.5 scale 0.2 })
Ball(normal { gradient y, 0.5 scale 0.2 sine_wave })
Ball(normal { onion 0.5 scale 0.15 })
Ball(normal { radial 0.5 frequency 8 triangle_wave })
Ball(normal { checker 0.5 scale 0.2 })
Ball(normal { brick 0.5 scale 0.06 })
Ball(normal { hexagon 0.5 scale 0.15 })
Ball(normal { spiral1 3, 0.4 scale 0.3 })
Ball(normal { gradient x scale 0.25 slope_map { [0 <0, 1>] [0.4 <1, 0>] [0.6 <1, -1>] [1 <0, 0>] } bump_size 0.7 })
Ball(normal { bozo scale 0.15 slope_map { [0.3 <0, 0>] [0.6 <1, 0>] } })
Ball(normal { bumps 0.6 scale S no_bump_scale })
Ball(normal { crackle 0.1 scale S no_bump_scale rotate 30 })
Ball(normal { gradient x normal_map { [0.2 bumps 0.6 scale S] [0.5 dents 1.2 scale S] [0.8 wrinkles 0.8 scale S] } scale 0.9 translate -0.5*x })
Ball(normal { checker normal { bumps scale S } normal { waves 0.5 scale S } scale 0.3 rotate 30 })
Ball(normal { average normal_map { [1 bumps 0.6 scale S] [2 ripples 0.6 scale 0.1] } rotate 20*x })
Ball(normal { bozo scale 0.2 normal_map { [0.4 quilted 0.8 scale S] [0.5 crackle 0.4 scale 0.2] } turbulence 0.3 })
Ball(normal { average normal_map { [gradient x, 0.6 scale 0.2] [gradient y, 0.6 scale 0.2] } })
Ball(normal { function { sin(x*30)*sin(y*30) } 0.1 })
Ball(normal { mandel 20 exponent 2 scale 0.2 bump_size 0.2 })
Ball(normal { gradient x warp { repeat x flip x } scale 0.1 warp { turbulence 0.05 } scale <2, 1, 1> })
#declare B = normal { bumps 0.3 scale S }
Ball(normal { B bump_size 1 })
Ball(normal { B wrinkles scale 2 })
Ball(normal { cells 0.5 scale 0.15 })
Ball(normal { pigment_pattern { checker rgb 0 rgb 1 scale 0.2 } 0.5 })
