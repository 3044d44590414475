// Language §8.3: a scene without #version.

//= the variable reads 3.7 all the same
#debug concat(str(version, 0, 2), "\n")
// expect: 3.70

//= semicolons are needed all the same
#declare A = 1
#declare B = 2;
// error: D0101 at 1:10
