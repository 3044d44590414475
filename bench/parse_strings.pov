// bench: +W8 +H6 -A; (e) 100,000 turns of a dozen string operations each
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -4> look_at 0 angle 50 }
light_source { <-4, 6, -6> rgb 1 }
#declare Names = array[10]
#for (I, 0, 9) #declare Names[I] = concat("part-", str(I, 0, 0)); #end
#declare Sum = 0;
#declare Line = "";
#for (I, 1, 100000)
  #local Name = strupr(concat(Names[mod(I, 10)], "/", str(I*0.37, -9, 3)));
  #local Tail = substr(Name, 5, 6);
  #local Place = vstr(3, <I, -I, 0.5*I>, ", ", 0, 2);
  #if (strcmp(Name, Line) > 0) #local Sum = Sum + strlen(Name); #else #local Sum = Sum - asc(Tail); #end
  #declare Line = concat(strlwr(Name), chr(65 + mod(I, 26)), Place);
  #local Sum = Sum + val(substr(Name, strlen(Name) - 3, 4));
#end
sphere { 0, 0.5 + mod(abs(Sum), 1)*0.5 pigment { rgb <mod(abs(Sum), 1), 0.5, mod(strlen(Line), 7)/7> } }
