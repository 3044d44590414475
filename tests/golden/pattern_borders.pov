// golden: +W64 +H64 -A; psnr >= 60; pixels exactly on the borders of tiles: what belongs to whom
#version 3.7;
global_settings { assumed_gamma 1 }
// Four pixels a unit, and every pixel is a quarter exactly.
camera { orthographic location <0, 0, -8> direction z right 16*x up 16*y }
#default { finish { ambient 1 diffuse 0 } }
#macro Tile(N)
  #local U = 4*mod(N, 4) - 8;
  #local V = 4*int(N/4) - 8;
  box {
    <U, V, 0>, <U + 4, V + 4, 1>
    pigment {
      #switch (N)
        #case (0) tiling 1 #break
        #case (1) tiling 3 #break
        #case (2) tiling 5 #break
        #case (3) tiling 6 #break
        #case (4) tiling 8 #break
        #case (5) tiling 9 #break
        #case (6) tiling 11 #break
        #case (7) tiling 12 #break
        #case (8) tiling 13 #break
        #case (9) tiling 14 #break
        #case (10) tiling 15 #break
        #case (11) tiling 18 #break
        #case (12) pavement #break
        #case (13) pavement number_of_sides 4 number_of_tiles 4 pattern 5 #break
        #case (14) pavement number_of_sides 4 number_of_tiles 6 pattern 17 interior 1 #break
        #case (15) pavement number_of_sides 6 number_of_tiles 3 pattern 2 #break
      #end
      color_map { [0 rgb <.1, 0, .3>] [.3 rgb x] [.5 rgb <1, .6, .2>] [.7 rgb y] [1 rgb 1] }
      matrix <1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0>
      translate <U + 2.125, V + 2.125, 0>
    }
  }
#end
#for (N, 0, 15) Tile(N) #end
