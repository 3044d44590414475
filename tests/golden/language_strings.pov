// golden: +W96 +H72 -A; psnr >= 50; the same objects must come out, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0.013, 0.007, -10> look_at <0.013, 0.007, 0> right 8*x up 6*y }  // off the grid: no pixel on an edge
light_source { <-6, 8, -12> rgb 1 }
background { rgb <0.2, 0.25, 0.35> }
#default { finish { ambient 0.25 } }
// A word drawn as dots from its letters, cut and joined by string functions.
#declare Text = concat(substr("Night of nine", 1, 5), "-", strlwr("SKY"), str(12.345, 0, 1), chr(65));
#for (I, 1, strlen(Text))
  #local Code = asc(substr(Text, I, 1));
  #for (K, 0, 6)
    #if (mod(div(Code, pow(2, K)), 2) = 1) sphere { <I*0.5 - 3.6, K*0.6 - 1.5, 0>, 0.24 pigment { rgb <I/14, 0.6, K/7> } } #end
  #end
#end
#if (strcmp(strupr("abc"), "ABC") = 0) box { <-3.5, -2.6, 0>, <val(concat("1", ".5")), -2.2, 1> pigment { rgb <0.8, 0.6, 0.2> } } #end
sphere { <strlen(vstr(3, <1, 2, 3>, ",", 0, 1))/4, -2.4, 0>, 0.3 pigment { rgb <0.4, 0.8, 0.4> } }
