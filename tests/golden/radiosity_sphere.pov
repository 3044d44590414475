// golden: +W32 +H24 -A; psnr >= 60; 0.1·(1 + 0.6 + 0.36 + 0.216 + 0.1296), exactly
#version 3.7;
global_settings { assumed_gamma 1 radiosity { recursion_limit 4 } }
camera { location 0 look_at z angle 60 }
sphere { 0, 5 pigment { rgb 1 } finish { diffuse 0.6 emission 0.1 ambient 0.5 } }
