// Objects §7, §8.5: the box of an inverse solid is that of the solid; what is inverse bounds no
// intersection.
#version 3.7;
#macro Tell(Thing)
  #local A = min_extent(Thing);
  #local B = max_extent(Thing);
  #local A = <max(A.x, -99), max(A.y, -99), max(A.z, -99)>;
  #local B = <min(B.x, 99), min(B.y, 99), min(B.z, 99)>;
  #debug concat(vstr(3, A, ",", 0, 3), " ", vstr(3, B, ",", 0, 3), "\n")
#end
#declare Cube = box { -1, 0.2 }
#declare Ball = sphere { 0, 1.2 }

//= an inverse union
Tell(union { object { Cube } object { Ball } inverse })
// expect: -1.200,-1.200,-1.200 1.200,1.200,1.200

//= an inverse merge
Tell(merge { object { Cube } object { Ball } inverse })
// expect: -1.200,-1.200,-1.200 1.200,1.200,1.200

//= an inverse intersection
Tell(intersection { object { Cube } object { Ball } inverse })
// expect: -1.000,-1.000,-1.000 0.200,0.200,0.200

//= an inverse difference
Tell(difference { object { Ball } object { Cube } inverse })
// expect: -1.200,-1.200,-1.200 1.200,1.200,1.200

//= an inverse union within a union
Tell(union { union { object { Cube } object { Ball } inverse } sphere { 0, 0.1 } })
// expect: -1.200,-1.200,-1.200 1.200,1.200,1.200

//= an inverse union that is moved
Tell(object { union { object { Cube } object { Ball } inverse } translate x rotate 30*y })
// expect: -0.773,-1.200,-2.139 2.505,1.200,1.139

//= a union that is taken away
Tell(difference { sphere { 0, 9 } union { object { Cube } object { Ball } } })
// expect: -9.000,-9.000,-9.000 9.000,9.000,9.000

//= an inverse union within an intersection
Tell(intersection { union { object { Cube } object { Ball } inverse } sphere { 0, 9 } })
// expect: -9.000,-9.000,-9.000 9.000,9.000,9.000

//= an intersection of what is inverse
Tell(intersection { box { -1, 0.2 inverse } sphere { 0, 1.2 inverse } })
// expect: -99.000,-99.000,-99.000 99.000,99.000,99.000

//= an inverse plane that is taken away
Tell(difference { box { -2, 2 } plane { y, 1 inverse } })
// expect: -2.000,-2.000,-2.000 2.000,1.000,2.000

//= a difference of what is inverse
Tell(difference { intersection { object { Cube } object { Ball } inverse } sphere { 0, 5 } })
// expect: -99.000,-99.000,-99.000 99.000,99.000,99.000
