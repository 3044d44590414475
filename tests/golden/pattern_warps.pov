// golden: +W160 +H120 -A; psnr >= 50; warps and their order, one per tile
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <4, 3, -10> direction z right 8*x up 6*y }
#declare N = 0;
#macro Tile(P)
  box {
    <0.02, 0.02, 0>, <0.98, 0.98, 1>
    pigment { P scale 0.4 rotate <10, 20, 30> translate <0.5, 0.5, 0.2> }
    finish { ambient 1 diffuse 0 }
    translate <mod(N, 8), div(N, 8), 0>
  }
  #declare N = N + 1;
#end
#declare C = color_map { [0 rgb 0] [0.3 rgb x] [0.6 rgb y] [1 rgb 1] }
Tile(pigment { bozo warp { turbulence 0.5 } })
Tile(pigment { bozo scale 0.4 warp { turbulence 0.5 octaves 3 omega 0.7 lambda 3 } })
Tile(pigment { bozo warp { turbulence <0.5, 0, 1> } scale 0.4 turbulence 0.3 })
Tile(pigment { marble turbulence 0.4 warp { turbulence 0.5 } })
Tile(pigment { wood rotate 40*x warp { turbulence 0.3 } turbulence 0.2 })
Tile(pigment { gradient x color_map { C } rotate 30*z warp { repeat x } })
Tile(pigment { spherical color_map { C } warp { repeat 0.7*x flip <1, 1, 0> } warp { repeat -0.5*y offset 0.3*x } })
Tile(pigment { gradient x color_map { C } rotate 45*z warp { repeat 0.3*y flip y } translate 0.2 })
Tile(pigment { checker scale 0.3 warp { black_hole <0.2, 0.1, -0.4>, 0.8 } })
Tile(pigment { checker scale 0.3 warp { black_hole <0, 0, -0.4>, 1 strength 2 falloff 3 inverse } })
Tile(pigment { checker scale 0.3 warp { black_hole <0.3, 0.3, 0.3>, 0.25 repeat <0.6, 0.6, 0.6> } })
Tile(pigment { checker scale 0.3 warp { black_hole <0.3, 0.3, 0.3>, 0.25 repeat <0.8, 0.8, 0> turbulence <0.3, 0.3, 0> falloff 1 } })
Tile(pigment { checker scale 0.1 warp { cylindrical } })
Tile(pigment { checker scale 0.1 warp { cylindrical orientation y dist_exp 1 } })
Tile(pigment { checker scale 0.1 warp { spherical } })
Tile(pigment { checker scale 0.1 warp { spherical orientation <1, 1, 0> dist_exp 0.5 } })
Tile(pigment { checker scale 0.1 warp { toroidal } })
Tile(pigment { checker scale 0.1 warp { toroidal major_radius 0.5 orientation x dist_exp 2 } })
Tile(pigment { checker scale 0.3 warp { planar } })
Tile(pigment { bozo color_map { C } scale 0.3 warp { planar y, 0.3 } rotate 20*x })
Tile(pigment { checker scale 0.05 warp { cubic } })
Tile(pigment { agate turbulence 0.3 scale 0.3 warp { repeat 0.5*x flip x } warp { repeat 0.5*y flip y } })
Tile(pigment { granite pigment_map { [0.4 checker scale 0.2 warp { turbulence 0.3 }] [0.6 rgb 1] } warp { repeat 0.4*x } })
Tile(pigment { crackle turbulence 0.2 translate 3 turbulence 0.3 octaves 2 })
