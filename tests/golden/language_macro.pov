// golden: +W96 +H72 -A; psnr >= 50; the same objects must come out, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0.013, 0.007, -10> look_at <0.013, 0.007, 0> right 8*x up 6*y }  // off the grid: no pixel on an edge
light_source { <-6, 8, -12> rgb 1 }
background { rgb <0.2, 0.25, 0.35> }
#default { finish { ambient 0.25 } }
// Parameters by value and by reference, locals, recursion, and macros that give values or parts of blocks.
#macro Twice(V) (2*V) #end
#macro Sum(A, B) A + B #end
#macro Grow(Size) #declare Size = Size*1.3; #end
#macro Paint(C) pigment { rgb C } finish { phong 0.5 } #end
#macro Tree(At, Way, Length, Depth)
  #local Tip = At + Way*Length;
  cylinder { At, Tip, 0.05*Depth Paint(<0.3 + 0.1*Depth, 0.5, 0.2>) }
  #if (Depth > 1)
    Tree(Tip, vrotate(Way, 28*z), Length*0.75, Depth - 1)
    Tree(Tip, vrotate(Way, -35*z), Length*0.7, Depth - 1)
  #end
#end
Tree(<-1.8, -2.6, 0>, y, 1.5, 5)
#declare R = 0.2;
#for (I, 0, 4) sphere { <1 + I*0.6, -2 + I*I*0.2, 0>, R Paint(<0.9, 0.2*I, 0.1>) } Grow(R) #end
sphere { <Twice(1.2), 2*Sum(0.5, 1.2), 0>, 0.3 Paint(<0.4, 0.6, 1>) }
box { <0.4, 2, 0>, <Sum(0.4, 0.5), Twice(1.3), 1> Paint(Sum(x, 0.5*y)) }
