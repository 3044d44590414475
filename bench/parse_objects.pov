// bench: +W8 +H6 -A; (c) 200,000 objects from nested macros
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -60> look_at 0 angle 60 }
light_source { <-40, 60, -60> rgb 1 }
#declare Dice = seed(11);
#declare Paint = array[4] { rgb <1, 0.6, 0.2>, rgb <0.3, 0.7, 1>, rgb <0.8, 0.9, 0.3>, rgb 0.8 }
#macro Knob(At, Size, Kind)
  #switch (mod(Kind, 3))
    #case (0) sphere { At, Size pigment { Paint[mod(Kind, 4)] } } #break
    #case (1) box { -Size, Size rotate 30*Kind*y translate At pigment { color Paint[mod(Kind, 4)] } } #break
    #else cylinder { At, At + 2*Size*y, 0.4*Size pigment { rgb Size } finish { phong 0.5 } }
  #end
#end
#macro Row(Base, Count)
  #local K = 0;
  #while (K < Count)
    Knob(Base + <K - Count/2, 0.3*rand(Dice), 0>, 0.1 + 0.3*rand(Dice), K)
    #local K = K + 1;
  #end
#end
#macro Layer(Base, Rows, Count)
  #for (R, 1, Rows) Row(Base + (R - Rows/2)*z, Count) #end
#end
#for (L, 1, 50) Layer((L - 25)*y, 80, 50) #end
