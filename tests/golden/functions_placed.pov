// golden: +W96 +H72 -A; psnr >= 60; positions, colours and patterns from functions, transforms and splines
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 6, -9> look_at <0, 0, 0> angle 50 }
light_source { <5, 12, -8>, 1 }
#declare Wave = function(a, b) { 0.6*sin(a*1.7)*cos(b) + sum(i, 1, 3, pow(-0.5, i)*sin(i*a)/i) }
#declare Bend = function { transform { rotate <10, 30, -20> scale <1, 0.8, 1.2> translate y*0.5 } }
#declare Path = spline { natural_spline -1, <-4,0,3> 0, <0,1.5,1> 1, <3.5,0.5,-2> 2, <4,3,2> }
#declare Tint = function { pigment { gradient x color_map { [0 rgb <1,.2,.1>] [.4 rgb <.2,1,.3>] [1 rgb <.1,.2,1>] } scale 5 } }
#declare Torus = function { internal(70) }
#declare Cells = function { pattern { checker scale 0.7 rotate 20*y } }
#for (I, -6, 6)
  #for (J, -4, 4)
    #local P = Bend(I*0.6, Wave(I*0.6, J*0.6), J*0.6);
    sphere { P, 0.12+0.08*Cells(P.x, P.y, P.z) pigment { color Tint(P.x, P.y, P.z) } }
  #end
#end
#for (T, -1, 2, 0.1)
  sphere { Path(T), 0.15 pigment { rgb <1, 1, 0>*(T < 0.5 ? 1 : 0.4) } }
#end
plane {
  y, -1.2
  pigment {
    function { Torus(x, y+1.2, z, 3, 0.8)*1.5 + 0.2*Cells(x, y, z) }
    color_map { [0 rgb 0.2] [0.3 rgb <.9,.8,.5>] [0.7 rgb <.3,.5,.8>] [1 rgb 1] }
    scale <1.1, 1, 0.9>
    triangle_wave
  }
}
